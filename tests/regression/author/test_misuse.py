# SPDX-License-Identifier: BSD-3-Clause
"""Common mistakes of authors: `netloft test` must name each, or the loader refuse it; and scenes whose plugin cannot be loaded.

The element is the one that `netloft new` writes, with one change.
"""
import unittest

from installed import WithInstallation

ELEMENT = "otter"
EVALUATE = """\
  struct Elastic {
    static netloft::Status evaluate(const Parameters& p, const Data& d, const netloft::State<2>& s, netloft::Local<2>& out) {
      const auto w = s.x[1] - s.x[0];
      if (norm(w) < 1e-6 * d.rest_length) throw netloft::OutsideDomain("a spring of no length");
      const double e = norm(w) - d.rest_length, T = p.k * e;
      BODY
      out.energy = 0.5 * p.k * e * e;
      out.force[0] = -(T / norm(w)) * w, out.force[1] = (T / norm(w)) * w;
      for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c) {
          const double t = w[r % 3] * w[c % 3] / dot(w, w);
          out.tangent[r][c] = s.cu * (r / 3 == c / 3 ? 1 : -1) * (p.k * t + T / norm(w) * ((r % 3 == c % 3) - t));
        }
      AFTER
      return netloft::Status::ok;
    }
  };
"""
TILE = """\
  struct Elastic {
    static netloft::Status tile(const netloft::Family<Otter>&, netloft_tile& t) {
      BODY
      return netloft::Status::ok;
    }
  };
"""
# f = k w_z² w is a force along the bar, but it has no potential.
ASYMMETRIC = """\
      out = {};
      const double g = p.k * w.z * w.z;
      out.force[0] = -g * w, out.force[1] = g * w;
      for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c)
          out.tangent[r][c] = s.cu * (r / 3 == c / 3 ? 1 : -1) * ((r % 3 == c % 3 ? g : 0) + (c % 3 == 2 ? 2 * p.k * w.z * w[r % 3] : 0));
"""
TRAITS = "<Otter::Elastic, netloft::conservative | netloft::symmetric>"


class Misuse(WithInstallation):
    def setUp(self):
        super().setUp()
        self.sh(f"netloft new element {ELEMENT} && mv otter/* . && rmdir otter")
        self.source = (self.folder / "otter.cpp").read_text()

    def element(self, term, body="", after="", before="", traits=TRAITS):
        """The file with its term replaced by another one."""
        begin, end = self.source.index("  struct Elastic {"), self.source.index("};\n\nNETLOFT_PLUGIN")
        text = self.source[:begin] + term.replace("BODY", body).replace("AFTER", after) + self.source[end:]
        text = text.replace("<Otter::Elastic>", traits)
        return "#include <cstdlib>\n#include <thread>\n" + text.replace("struct Otter {", before + "\nstruct Otter {")

    def compile(self, text, flags="$(netloft --cflags)", file="otter.so"):
        self.write("otter.cpp", text)
        self.sh(f"c++ {flags} otter.cpp -o {file}")

    def found(self, text, check, **how):
        self.compile(text, **how)
        ended = self.sh("netloft test otter.so", expect=1)
        failed = [line.split()[1] for line in ended.out.splitlines() if line.startswith("  FAILED")]
        self.assertIn(check, failed, ended)
        self.assertIn("usually: ", ended.out)

    def test_the_element_itself_is_right(self):
        self.compile(self.element(EVALUATE))
        self.sh("netloft test otter.so")

    def test_state_in_evaluate(self):
        self.found(self.element(EVALUATE, after="static double calls = 0; out.energy += ++calls;"), "no-hidden-state")

    def test_writing_past_its_lanes(self):
        self.found(self.element(TILE, "for (int i = 0; t.force && i < 6 * 64; ++i) t.force[i] += 1;", traits="<Otter::Elastic>"),
                   "nothing-written-past-count")

    def test_writing_far_past_its_lanes(self):
        self.compile(self.element(TILE, "for (long i = 0; t.force && i < 1L << 33; ++i) t.force[i] += 1;", traits="<Otter::Elastic>"))
        ended = self.sh("netloft test otter.so", expect=1)
        self.assertRegex(ended.err, "otter/otter crashed in (the check [a-z-]+|its construction or first evaluation)[^\n]*\n  usually: ")

    def test_an_exception(self):
        self.found(self.element(EVALUATE, 'if (e > 0) throw std::runtime_error("unfinished");'), "evaluates-without-error")

    def test_a_thread(self):
        self.found(self.element(EVALUATE, "if (s.x[0].x > 0) std::jthread([] {}).join();"), "starts-no-threads",
                   flags="$(netloft --cflags) -pthread")

    def test_not_a_number(self):
        self.found(self.element(EVALUATE, after="if (e > 0) out.force[1].y = std::sqrt(-e);"), "outputs-finite")

    def test_a_tangent_that_is_not_symmetric(self):
        self.found(self.element(EVALUATE, after=ASYMMETRIC, traits="<Otter::Elastic, netloft::symmetric>"), "symmetric-where-claimed")

    def test_the_time_read_and_not_declared(self):
        grows = "for (auto& f : out.force) f = f * g;\nfor (auto& row : out.tangent)\nfor (double& entry : row) entry *= g;"
        self.found(self.element(EVALUATE, after=f"const double g = 1 + s.time; out.energy *= g; {grows}"), "reads-the-inputs-it-declares")
        self.assertIn("term elastic reads the time without the trait reads_time", self.sh("netloft test otter.so", expect=1).out)

    def test_checks_that_do_not_apply_are_counted_and_listed_on_demand(self):
        self.compile(self.element(EVALUATE))
        short, long = (self.sh(f"netloft test otter.so {more}").out for more in ("", "--verbose"))
        self.assertNotIn("skipped", short)
        self.assertIn(f"  {long.count('  skipped ')} checks do not apply", short)
        self.assertIn("--verbose lists them", short)
        self.compile(self.element(EVALUATE, 'throw std::runtime_error("unfinished");'))
        self.assertRegex(self.sh("netloft test otter.so", expect=1).out, r"  \d+ checks depend on one that failed: --verbose lists them\n")

    def test_exported_symbols(self):
        self.found(self.element(EVALUATE, before="double helper_of_mine(double x) { return x; }"), "exports-one-symbol",
                   flags="-std=c++20 -O2 -fPIC -shared -I$(dirname $(dirname $(which netloft)))/include")
        self.assertIn("helper_of_mine", self.sh("netloft test otter.so", expect=1).out)

    def test_a_datum_with_a_slip(self):
        self.compile(self.source.replace('e.data("rest_length"', 'e.data("rest_lenght"'))
        ended = self.sh("netloft run otter.toml --plugins .", expect=2)
        self.assertIn("rest_lenght: is missing: otter/otter needs it, and netloft does not give it", ended.err)
        self.assertIn('did its author mean "rest_length" (unstretched length of the bar)?', ended.err)

    def test_a_datum_in_another_unit(self):
        self.compile(self.source.replace('rest_length, "m"', 'rest_length, "mm"'))
        self.assertIn('datum "rest_length" is 1 number in mm; under this name the host gives 1 number in m',
                      self.sh("netloft test otter.so", expect=4).err)

    def test_fast_math(self):
        self.compile(self.source, flags="$(netloft --cflags) -ffast-math")
        self.assertRegex(self.sh("netloft test otter.so", expect=4).err, "otter.so: .*-ffast-math.*build it without")


class Unavailable(WithInstallation):
    """A scene whose plugin cannot be loaded: exit 4, one message with the file and the reason, and no result."""

    def setUp(self):
        super().setUp()
        self.sh("netloft new element otter && mv otter/* . && rmdir otter")

    def refused(self, *words, command="netloft run otter.toml --plugins ."):
        for json in ("", " --json"):
            ended = self.sh(command + json, expect=4)
            self.assertEqual(ended.err.count("error") + ended.err.count("netloft:"), 1, ended)
            for word in words:
                self.assertIn(word, ended.err)
        self.assertFalse(list(self.folder.glob("*.hdf*")))

    def compile(self, source="otter.cpp", flags="", file="otter.so"):
        self.sh(f"c++ $(netloft --cflags) {flags} {source} -o {file}")

    def prepend(self, text):
        self.write("otter.cpp", text + (self.folder / "otter.cpp").read_text())

    def test_missing(self):
        self.refused('there is no plugin "otter"', "tried ./otter.so", "lib/netloft/otter.so")

    def test_misspelt(self):
        self.sh("netloft new element ottar && c++ $(netloft --cflags) ottar/ottar.cpp -o ottar.so")
        self.refused('did you mean "ottar"?')

    def test_shadowed(self):
        (self.folder / "other").mkdir()
        self.compile()
        self.sh("sed 's,\"otter\"\\, \"Spring,\"board\"\\, \"Spring,' otter.cpp > other.cpp")
        self.compile("other.cpp", file="other/otter.so")
        self.refused('the plugin "otter" has no element "otter/otter"', "other/otter.so hides ./otter.so",
                     command="netloft run otter.toml --plugins other --plugins .")

    def test_of_another_abi(self):
        self.sh("sed -i 's/finish(name, version, doc);/finish(name, version, doc);/' otter.cpp")
        self.sh("cp -r $(dirname $(dirname $(which netloft)))/include include")
        header = self.folder / "include" / "netloft" / "plugin.h"
        text = header.read_text()
        for define, says in (("MAJOR", "build the plugin again with this program's headers"), ("MINOR", "update the program")):
            changed = "\n".join(line.rsplit(" ", 1)[0] + " 99" if line.startswith(f"#define NETLOFT_ABI_{define}") else line
                                for line in text.splitlines())
            header.write_text(changed + "\n")
            self.sh("c++ -Iinclude $(netloft --cflags) otter.cpp -o otter.so")
            self.refused("otter.so: built for", says)

    def test_crashes_while_opening(self):
        self.prepend("static int crash = *(volatile int*)8;\n")
        self.compile()
        self.refused("otter.so: crashed while it was opened (Segmentation fault)")

    def test_ends_the_program_while_opening(self):
        self.prepend("#include <cstdlib>\nstatic int gone = (std::exit(0), 0);\n")
        self.compile()
        self.refused("otter.so: ended the program while it was opened")

    def test_throws_while_opening(self):
        self.prepend("static int thrown = (throw 1, 0);\n")
        self.compile()
        self.refused("otter.so: crashed while it was opened (Aborted)")

    def test_is_no_plugin(self):
        self.write("otter.so", "something else")
        self.refused("otter.so: cannot open the plugin")

    def test_a_broken_solver(self):
        self.write("gone.cpp", "static int crash = *(volatile int*)8;\n")
        self.compile("gone.cpp", file="gone.so")
        self.compile()
        self.refused("gone.so: crashed while it was opened", command="netloft run otter.toml --plugins . --solver gone")


if __name__ == "__main__":
    unittest.main(verbosity=2)
