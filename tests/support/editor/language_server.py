# SPDX-License-Identifier: BSD-3-Clause
"""A session with a language server over standard streams: enough of the protocol to open a text and ask about it."""
import json
import subprocess


class LanguageServer:
    def __init__(self, command, folder):
        self.process = subprocess.Popen(command, cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.folder, self.last, self.diagnostics = folder, 0, {}
        self.request("initialize", {"processId": None, "rootUri": folder.as_uri(), "capabilities": {
            "workspace": {"configuration": True}, "textDocument": {"completion": {"completionItem": {"snippetSupport": True}}}},
            "workspaceFolders": [{"uri": folder.as_uri(), "name": "scenes"}]})
        self.notify("initialized", {})

    def send(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        self.process.stdin.flush()

    def receive(self):
        length = 0
        while (line := self.process.stdout.readline().strip()):
            if line.lower().startswith(b"content-length:"):
                length = int(line.split(b":")[1])
        if not length:
            raise EOFError("the language server has ended")
        return json.loads(self.process.stdout.read(length))

    def handle(self, message):
        """Answers a request of the server, or stores the diagnostics that it sends."""
        if message.get("method") == "textDocument/publishDiagnostics":
            self.diagnostics[message["params"]["uri"]] = message["params"]["diagnostics"]
        if "method" in message and "id" in message:
            items = message.get("params", {}).get("items", []) if message.get("params") else []
            self.send({"id": message["id"], "result": [{} for _ in items] if items else None})

    def request(self, method, params):
        self.last += 1
        self.send({"id": self.last, "method": method, "params": params})
        while True:
            message = self.receive()
            if message.get("id") == self.last and "method" not in message:
                return message.get("result")
            self.handle(message)

    def notify(self, method, params):
        self.send({"method": method, "params": params})

    def open(self, name, text):
        """Opens a text under a name and waits for its diagnostics."""
        uri = (self.folder / name).as_uri()
        (self.folder / name).write_text(text)
        self.notify("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": "toml", "version": 1, "text": text}})
        while uri not in self.diagnostics:
            self.handle(self.receive())
        return uri

    def completions(self, uri, line, character):
        result = self.request("textDocument/completion", {"textDocument": {"uri": uri}, "position": {"line": line, "character": character}})
        items = result["items"] if isinstance(result, dict) else result or []
        return [item["label"] for item in items]

    def hover(self, uri, line, character):
        result = self.request("textDocument/hover", {"textDocument": {"uri": uri}, "position": {"line": line, "character": character}})
        return json.dumps(result)

    def close(self):
        self.process.kill()
        self.process.wait()
