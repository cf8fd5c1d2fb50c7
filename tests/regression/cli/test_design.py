# SPDX-License-Identifier: BSD-3-Clause
"""`netloft serve` as used by a program: the examples of DESIGN.md in their order, saved files, and requests that it must refuse."""
import concurrent.futures
import http.client
import json
import os
import re
import signal
import socket
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from program import LINE, PROGRAM, SOURCE

BLOCK = re.compile(r"^```json (\w+)\n(.*?)^```", re.DOTALL | re.MULTILINE)
SCENE = "gear-library/scenes/83-112-flume-3.0kn.toml"


class Served:
    """A program that serves a scene of the library, or one with this text, in a separate folder."""

    def __init__(self, scene=SCENE, command="serve", text=None, words=(), more=()):
        self.keeper = tempfile.TemporaryDirectory()
        self.folder = Path(self.keeper.name)
        self.code = 0
        (self.folder / "gear-library").symlink_to(SOURCE / "gear-library")
        if text is not None:
            (self.folder / scene).write_text(text)
        for name, content in dict(more).items():
            (self.folder / name).write_text(content)
        self.process = subprocess.Popen([PROGRAM, command, scene, "--json", "--threads", "1", *words], cwd=self.folder, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.address = json.loads(self.process.stdout.readline())["address"]
        self.host, self.token = re.fullmatch(r"http://(127\.0\.0\.1:\d+)/(\w+)/", self.address).groups()

    def request(self, method, target, body=None, headers=(), host=None):
        connection = http.client.HTTPConnection(self.host, timeout=120)
        connection.putrequest(method, target, skip_host=True, skip_accept_encoding=True)
        given = {"Host": host or self.host, **({"Content-Type": "application/json", "Content-Length": str(len(body))} if body is not None else {}),
                 **dict(headers)}
        for name, value in given.items():
            if value is not None:
                connection.putheader(name, value)
        connection.endheaders(body)
        reply = connection.getresponse()
        text = reply.read()
        connection.close()
        return reply, text

    def ask(self, name, **body):
        reply, text = self.request("POST", f"/{self.token}/api/{name}", json.dumps(body).encode())
        return reply.status, json.loads(text)

    def end(self, test):
        self.process.send_signal(signal.SIGINT)
        test.assertEqual(self.process.wait(20), self.code, self.process.stderr.read())
        self.process.stdout.close()
        self.process.stderr.close()
        self.keeper.cleanup()


def has_the_form_of(found, shown, test, where):
    """Whether an answer has the members that an example shows, of the same kinds."""
    if isinstance(shown, dict):
        test.assertIsInstance(found, dict, where)
        for key, value in shown.items():
            test.assertIn(key, found, where)
            has_the_form_of(found[key], value, test, f"{where}.{key}")
    elif isinstance(shown, list):
        test.assertIsInstance(found, list, where)
        for value in shown[:1]:
            test.assertTrue(found, where)
            has_the_form_of(found[0], value, test, f"{where}[0]")
    elif isinstance(shown, (int, float)) and not isinstance(shown, bool):
        test.assertIsInstance(found, (int, float), where)
    else:
        test.assertIsInstance(found, type(shown), where)


class Examples(unittest.TestCase):
    def test_of_the_page_work_in_their_order(self):
        served = Served()
        self.addCleanup(served.end, self)
        blocks = BLOCK.findall((SOURCE / "io/design/DESIGN.md").read_text())
        asked, answer = set(), None
        for name, text in blocks:
            body = json.loads(text)
            if name == "answer":
                has_the_form_of(answer, body, self, f"answer to {last}")
                continue
            last = name
            asked.add(name)
            status, answer = served.ask(name, **body)
            self.assertEqual(status, 200, f"{name} {body}: {answer}")
        status, answer = served.ask("frobnicate")
        self.assertEqual(status, 400)
        for name in ("state", "apply", "undo", "redo", "save", "check", "solve", "run", "stop", "jvp", "picture", "plan", "report", "catalogue", "export", "errors", "beside", "parts", "add", "remove", "influences", "sweep", "reach", "range"):
            self.assertIn(name, asked)

    def test_save_and_undo_keep_texts_to_the_byte(self):
        text = f"include = [\"{SOURCE / SCENE}\"]   # the trawl\n\n[tow]\nspeed =  \"2.9 kn\"   # slow\n[gear]\nnodes = 150\n"
        served = Served("own.toml", text=text)
        self.addCleanup(served.end, self)
        self.assertEqual(served.ask("solve")[1]["status"], "converged")
        for value in (2.95, 3.0, 3.05):
            served.ask("apply", path="tow.speed", to=value)
        self.assertEqual((served.folder / "own.toml").read_text(), text)
        self.assertEqual(served.ask("save")[1]["written"], ["own.toml"])
        self.assertEqual((served.folder / "own.toml").read_text(), text.replace("2.9", "3.05"))
        for _ in range(3):
            state = served.ask("undo")[1]
        self.assertFalse(state["can_undo"])
        served.ask("save")
        self.assertEqual((served.folder / "own.toml").read_text(), text)

    def test_a_saved_design_has_the_figures_that_were_shown(self):
        text = f"include = [\"{SOURCE / SCENE}\"]\n[gear]\nnodes = 150\n"
        served = Served("own.toml", text=text)
        self.addCleanup(served.end, self)
        served.ask("solve")
        served.ask("apply", path="ropes.headrope.length", to=25.6, wait=True)
        served.ask("apply", path="tow.speed", to=3.2, wait=True)
        confirmed = served.ask("run")[1]
        self.assertTrue(confirmed["as_run"])
        shown = {f["name"]: f["value"] for f in confirmed["figures"]}
        served.ask("save")
        run = subprocess.run([PROGRAM, "run", "own.toml", "--json", "-o", "own.hdf"], cwd=served.folder, capture_output=True, text=True, timeout=100)
        self.assertEqual(run.returncode, 0, run.stderr)
        figures = json.loads(run.stdout)["gear"]["figures"]
        self.assertGreater(len(figures), 20)
        for name, value in figures.items():
            self.assertEqual(shown[name], value, name)

    def test_another_gear_or_the_start_stands_beside(self):
        text = f"include = [\"{SOURCE / SCENE}\"]\n[gear]\nnodes = 150\n"
        served = Served("own.toml", text=text, words=("--beside", "slow.toml"), more={"slow.toml": text + "[tow]\nspeed = \"2.5 kn\"\n"})
        self.addCleanup(served.end, self)
        self.assertEqual(served.ask("state")[1]["beside"], "slow.toml")
        first = served.ask("solve")[1]["figures"]
        values = lambda figures: {f["name"]: f["value"] for f in figures}
        slow = served.ask("beside", file="slow.toml")[1]
        self.assertGreater(values(slow["figures"])["mouth/headline_height"], values(first)["mouth/headline_height"])
        self.assertEqual(len(slow["picture"]["results"]), 1)
        served.ask("apply", path="tow.speed", to=2.5, wait=True)
        now = served.ask("run")[1]["figures"]
        self.assertEqual(values(served.ask("beside", of="now")[1]["figures"]), values(now))
        self.assertEqual(values(now), values(slow["figures"]))  # both as a run finds them
        self.assertEqual(values(served.ask("beside", of="start")[1]["figures"]), values(first))
        self.assertEqual(served.ask("beside", of="end")[0], 400)
        for wrong, sentence in (("none.toml", "none.toml"), ("own.hdf", "own.hdf")):
            status, answer = served.ask("beside", file=wrong)
            self.assertEqual(status, 422)
            self.assertIn(sentence, answer["error"])

    def test_the_page_comes_with_a_policy_that_lets_nothing_else_in(self):
        served = Served(command="design")
        self.addCleanup(served.end, self)
        reply, page = served.request("GET", f"/{served.token}/")
        self.assertEqual(reply.status, 200)
        nonce = re.search(r"script-src 'nonce-(\w+)'", reply.headers["Content-Security-Policy"])[1]
        self.assertEqual(page.count(b"<script"), page.count(f'<script nonce="{nonce}"'.encode()))
        self.assertNotIn(b"http://", page.replace(b"http://www.w3.org", b"").split(b"</style>")[0])
        self.assertIsNone(reply.headers["Access-Control-Allow-Origin"])
        self.assertNotIn(nonce, served.request("GET", f"/{served.token}/")[0].headers["Content-Security-Policy"])


class Browsers(unittest.TestCase):
    def test_are_opened_by_the_desktop_with_the_address_that_is_printed(self):
        with tempfile.TemporaryDirectory() as folder:
            stub, opened = Path(folder) / "xdg-open", Path(folder) / "opened"
            stub.write_text(f'#!/bin/sh\necho "$@" > "{opened}.new" && mv "{opened}.new" "{opened}"\n')
            stub.chmod(0o755)
            design = subprocess.Popen([PROGRAM, "design", SOURCE / SCENE, "--threads", "1"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                      env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", "DISPLAY": ":99"})
            address = design.stdout.readline()
            for _ in range(500):
                if opened.exists():
                    break
                time.sleep(0.02)
            design.send_signal(signal.SIGINT)
            design.communicate(timeout=30)
            self.assertEqual(opened.read_text(), address)
            self.assertRegex(address, r"^http://127\.0\.0\.1:\d+/\w+/$")


class Solvers(unittest.TestCase):
    """A design outlives its solver: the page gets a sentence, and the text can be taken back."""
    EVIL = '[parts.evil]\ntype = "hostile/%s"\non = "line.end"\n'

    def setUp(self):
        self.served = Served("line.toml", text=LINE, words=("--plugins", os.environ["NETLOFT_TEST_PLUGINS"]))
        self.addCleanup(self.served.end, self)
        self.first = self.solver()

    def solver(self):
        """The process of the solver, which has an equilibrium."""
        self.assertEqual(self.served.ask("solve")[1]["status"], "converged")
        children = Path(f"/proc/{self.served.process.pid}/task").glob("*/children")
        found = [int(pid) for file in children for pid in file.read_text().split()]
        self.assertEqual(len(found), 1)
        return found[0]

    def change(self, text, wait):
        return self.served.ask("apply", file="line.toml", text=text, wait=wait)[1]

    def go_back(self):
        self.assertTrue(self.served.ask("undo")[1]["can_redo"])
        self.assertNotEqual(self.solver(), self.first)
        outcome = self.served.ask("apply", path="parts.line.length", to=10.5, wait=True)[1]["outcome"]
        self.assertEqual(outcome["status"], "converged")
        self.assertLess(outcome["ghost_off"], 0.01)

    def test_that_crash_are_named_and_replaced(self):
        outcome = self.change(LINE + self.EVIL % "crashes", True)["outcome"]
        self.assertEqual(outcome["status"], "solver ended")
        self.assertIn("hostile/crashes crashed in term pull (Segmentation fault)", outcome["sentence"])
        self.go_back()

    def test_that_exit_are_named_and_replaced(self):
        outcome = self.change(LINE + self.EVIL % "exits", True)["outcome"]
        self.assertEqual(outcome["status"], "solver ended")
        self.assertIn("hostile/exits ended the program (exit) in term pull", outcome["sentence"])
        self.go_back()

    def test_that_never_return_are_ended_by_the_next_change(self):
        self.change(LINE + self.EVIL % "loops", False)
        time.sleep(0.3)
        self.go_back()

    def test_that_never_return_are_ended_on_demand(self):
        self.change(LINE + self.EVIL % "loops", False)
        time.sleep(0.3)
        self.assertEqual(self.served.ask("stop")[0], 200)
        outcome = self.served.ask("solve")[1]
        self.assertEqual(outcome["status"], "solver ended")
        self.assertIn("hostile/loops, term pull, did not return", outcome["sentence"])
        self.go_back()

    def test_that_are_killed_are_replaced(self):
        os.kill(self.first, signal.SIGKILL)
        outcome = self.served.ask("apply", path="parts.line.length", to=10.2, wait=True)[1]["outcome"]
        self.assertEqual(outcome["status"], "solver ended")
        self.assertIn("signal 9", outcome["sentence"])
        self.go_back()

    def test_end_with_a_design_that_is_killed(self):
        self.served.code = -signal.SIGKILL
        os.kill(self.served.process.pid, signal.SIGKILL)
        self.served.process.wait()
        self.assertTrue(self.ends(self.first))

    @staticmethod
    def ends(pid, most=5):
        for _ in range(int(100 * most)):
            try:
                if Path(f"/proc/{pid}/stat").read_text().split()[2] == "Z":
                    return True
            except OSError:
                return True
            time.sleep(0.01)
        return False


class Attacks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.served = Served("own.toml", text=f'include = ["{SOURCE / SCENE}"]\n[gear]\nnodes = 100\n')
        cls.served.ask("solve")
        cls.before = {p: p.read_bytes() for p in cls.served.folder.glob("*") if p.is_file()}

    @classmethod
    def tearDownClass(cls):
        cls.served.end(cls("test_are_refused_and_write_nothing"))

    def is_as_before(self):
        now = {p: p.read_bytes() for p in self.served.folder.glob("*") if p.is_file()}
        self.assertEqual(now, self.before)
        self.assertEqual(self.served.ask("solve")[0], 200)

    def test_are_refused_and_write_nothing(self):
        api = f"/{self.served.token}/api/"
        save, port = json.dumps({"as": "evil.toml"}).encode(), self.served.host.split(":")[1]
        for what, method, target, body, headers, host, status in (
                ("another host", "POST", api + "save", save, {}, "evil.example", 403),
                ("a name that resolves to here", "POST", api + "save", save, {}, f"evil.example:{port}", 403),
                ("another port", "POST", api + "save", save, {}, "127.0.0.1:1", 403),
                ("the page of another site", "POST", api + "save", save, {"Origin": "http://evil.example"}, None, 403),
                ("a page without origin", "POST", api + "save", save, {"Origin": "null"}, None, 403),
                ("a page on another port", "POST", api + "save", save, {"Origin": "http://127.0.0.1:1"}, None, 403),
                ("a request across sites", "POST", api + "save", save, {"Sec-Fetch-Site": "cross-site"}, None, 403),
                ("a link from another site", "GET", f"/{self.served.token}/", None, {"Sec-Fetch-Site": "cross-site"}, None, 403),
                ("no token", "POST", "/api/save", save, {}, None, 403),
                ("a wrong token", "POST", "/" + 32 * "0" + "/api/save", save, {}, None, 403),
                ("half a token", "POST", f"/{self.served.token[:16]}/api/save", save, {}, None, 403),
                ("the root", "GET", "/", None, {}, None, 403),
                ("a path upwards", "GET", f"/{self.served.token}/../../etc/passwd", None, {}, None, 404),
                ("an encoded path upwards", "GET", f"/{self.served.token}/%2e%2e/own.toml", None, {}, None, 404),
                ("a form", "POST", api + "save", b"as=evil.toml", {"Content-Type": "application/x-www-form-urlencoded"}, None, 415),
                ("a form with text", "POST", api + "save", save, {"Content-Type": "text/plain"}, None, 415),
                ("no type", "POST", api + "save", save, {"Content-Type": None}, None, 415),
                ("another method", "PUT", api + "save", save, {}, None, 405),
                ("a question whether it may", "OPTIONS", api + "save", None, {"Origin": "http://evil.example"}, None, 403),
                ("no JSON", "POST", api + "save", b"{", {}, None, 400),
                ("an array", "POST", api + "save", b"[1]", {}, None, 400),
                ("deep JSON", "POST", api + "apply", 100000 * b"[" + 100000 * b"]", {}, None, 400),
                ("bytes that are no text", "POST", api + "apply", b'{"set": "\xff\xfe"}', {}, None, 400),
                ("a long body", "POST", api + "save", b"x", {"Content-Length": "99999999"}, None, 413),
                ("a body in chunks", "POST", api + "save", b"", {"Transfer-Encoding": "chunked"}, None, 501),
                ("a save upwards", "POST", api + "save", b'{"as": "../evil.toml"}', {}, None, 422),
                ("a save to a place", "POST", api + "save", b'{"as": "/tmp/evil.toml"}', {}, None, 422),
                ("a save of another kind", "POST", api + "save", b'{"as": ".bashrc"}', {}, None, 422),
                ("a file that is not here", "POST", api + "apply", b'{"file": "/etc/passwd", "text": ""}', {}, None, 422),
                ("an include that is set", "POST", api + "apply", b'{"set": "include=[\\"/etc/passwd\\"]"}', {}, None, 422)):
            with self.subTest(what):
                reply, text = self.served.request(method, target, body, headers.items(), host)
                self.assertEqual(reply.status, status, text)
                self.assertTrue(json.loads(text)["error"])
                self.assertIsNone(reply.headers["Access-Control-Allow-Origin"])
        self.is_as_before()

    def raw(self, sent):
        with socket.create_connection(self.served.host.split(":"), timeout=30) as connection:
            connection.sendall(sent)
            return connection.recv(100)

    def test_that_are_no_requests_are_answered_or_dropped(self):
        for sent in (b"\r\n\r\n", b"GET\r\n\r\n", 20000 * b"x", b"GET / HTTP/1.1\r\n" + 2000 * b"A: b\r\n" + b"\r\n", bytes(range(256)) + b"\r\n\r\n"):
            self.assertRegex(self.raw(sent), rb"^HTTP/1.1 (400|431) ")
        self.is_as_before()

    def test_of_a_hundred_connections_at_once_leave_it_answering(self):
        idle = [socket.create_connection(self.served.host.split(":"), timeout=30) for _ in range(100)]
        with concurrent.futures.ThreadPoolExecutor(20) as pool:
            for status, _ in pool.map(lambda _: self.served.ask("state"), range(20)):
                self.assertEqual(status, 200)
        for connection in idle:
            connection.close()
        self.is_as_before()

    def test_names_that_are_markup_stay_text(self):
        served = Served("own.toml", text=f'include = ["{SOURCE / SCENE}"]\n[gear]\nnodes = 100\ntitle = "<img src=x onerror=alert(1)>"\n')
        self.addCleanup(served.end, self)
        self.assertEqual(served.ask("solve")[1]["status"], "converged")
        report = served.ask("report")[1]
        for table in ("summary", "materials", "deck"):
            self.assertNotIn("<img", report[table])
        self.assertNotIn("<img", served.ask("plan")[1]["svg"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
