import json, urllib.request

class Service:
    def __init__(self, name, url="http://localhost:8888"):
        self.address = "%s/api/service/%s/" % (url, name)
    def __getattr__(self, method):
        def call(*arguments):
            request = urllib.request.Request(self.address + method, json.dumps(arguments).encode(), {"Content-Type": "application/json"})
            with urllib.request.urlopen(request) as answer:
                return json.loads(answer.read() or b"null")
        return call
