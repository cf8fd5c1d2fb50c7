# SPDX-License-Identifier: BSD-3-Clause
"""Reference pages: one for every component, in both formats, with every parameter and no dead link."""
import html.parser
import json
import re
import unittest

from installed import WithInstallation


class Links(html.parser.HTMLParser):
    """Collects links and names, and insists that tags are closed in order."""

    def __init__(self, text):
        super().__init__()
        self.links, self.codes, self.open = [], [], []
        self.feed(text)
        assert not self.open, self.open

    def handle_starttag(self, tag, attributes):
        if tag not in ("meta",):
            self.open.append(tag)
        self.links += [value for name, value in attributes if name == "href"]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, text):
        if self.open and self.open[-1] == "code":
            self.codes.append(text)


class Reference(WithInstallation):
    def components(self):
        return json.loads(self.sh("netloft list --json").out)["components"]

    def test_installed_pages_name_every_component_and_parameter(self):
        pages = self.installed.prefix / "share" / "doc" / "netloft" / "reference"
        self.assertGreaterEqual(len(self.components()), 12)
        for c in self.components():
            described = json.loads(self.sh(f"netloft describe {c['type']} --json").out)
            name = c["type"].replace("/", "-")
            markdown, page = (pages / f"{name}.md").read_text(), Links((pages / f"{name}.html").read_text())
            for p in described.get("parameters", []):
                self.assertIn(f"| `{p['name']}` |", markdown)
                self.assertIn(p["name"], page.codes)

    def test_links_lead_somewhere(self):
        self.sh("netloft reference pages")
        pages = self.folder / "pages"
        for link in Links((pages / "index.html").read_text()).links + re.findall(r"\]\(([^)]+)\)", (pages / "index.md").read_text()):
            self.assertTrue((pages / link).is_file(), link)
        self.assertEqual(json.loads((pages / "scene.schema.json").read_text()), json.loads(self.sh("netloft schema").out))

    def test_a_plugin_of_ones_own_has_a_page(self):
        self.sh("netloft new element otter && c++ $(netloft --cflags) otter/otter.cpp -o otter.so")
        self.sh("netloft reference pages --plugins .")
        self.assertIn("stiffness at rest", (self.folder / "pages" / "otter-otter.md").read_text())

    def test_a_strategy_of_ones_own_is_listed_described_and_completed(self):
        self.sh("netloft new strategy otter && c++ $(netloft --cflags) otter/otter.cpp -o otter.so")
        listed = json.loads(self.sh("netloft list --json --plugins .").out)["components"]
        self.assertIn(("otter/otter", "strategy"), [(c["type"], c["kind"]) for c in listed])
        described = json.loads(self.sh("netloft describe otter/otter --json --plugins .").out)
        self.assertEqual([p["name"] for p in described["parameters"]], ["softest", "factor"])
        table = json.loads(self.sh("netloft schema --plugins .").out)["properties"]["analysis"]["properties"]["otter"]
        self.assertEqual(sorted(table["properties"]), ["factor", "softest"])
        self.sh("netloft reference pages --plugins .")
        self.assertIn("| `softest` |", (self.folder / "pages" / "otter-otter.md").read_text())

    def test_a_file_in_the_way(self):
        self.write("pages", "")
        self.assertIn("is no folder", self.sh("netloft reference pages", expect=2).err)


if __name__ == "__main__":
    unittest.main(verbosity=2)
