"""Gives projects to the generator of Beremiz: generate.py FOLDER PROJECT.xml...

FOLDER holds Beremiz. What the generator makes of NAME.xml goes to NAME.st; what it says against it, to NAME.err.
Nothing is shown, so that everything that belongs to a screen is a stand-in that does nothing.
"""

import builtins
import os
import sys
import traceback
import types


class Nothing(int):
    """Can be called, asked for attributes, and computed with."""

    def __new__(cls, *_arguments, **_named):
        return int.__new__(cls, 0)

    def __init__(self, *_arguments, **_named):
        pass

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return Nothing()

    def __call__(self, *_arguments, **_named):
        return Nothing()


class Module(types.ModuleType):
    """Has a class of every name that looks like one."""

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        if name[0].isupper() and not name.isupper() and "_" not in name:
            return type(name, (Nothing,), {})
        return Nothing()


def pretend(name, **contents):
    module = sys.modules[name] = Module(name)
    for key, value in contents.items():
        setattr(module, key, value)
    if "." in name:
        parent, last = name.rsplit(".", 1)
        setattr(sys.modules[parent], last, module)


def find_by_table(body):
    """Looks objects up in a table: Beremiz searches the whole drawing for each."""
    tables = {}

    def find(self, local_id):
        content = self.content
        if content not in tables:
            tables[content] = {int(instance.getlocalId()): instance for instance in self.getcontentInstances()}
        return tables[content].get(int(local_id))

    body.getcontentInstance = find


def main(folder, projects):
    sys.path.insert(0, folder)
    screen = "wx wx.lib wx.lib.buttons wx.lib.agw wx.grid wx.adv wx.dataview wx.stc wx.aui controls controls.CustomToolTip"
    for name in screen.split():
        pretend(name)
    pretend("graphics", __path__=[os.path.join(folder, "graphics")])
    pretend("graphics.ToolTipProducer")
    builtins._ = lambda text: text
    from PLCControler import PLCControler
    from plcopen.plcopen import PLCOpenParser

    find_by_table(PLCOpenParser.GetElementClass("body"))
    for project in projects:
        name = os.path.splitext(project)[0]
        try:
            controler = PLCControler()
            said = controler.OpenXMLFile(project)
            if said is not None:
                raise ValueError(said)
            text, errors, warnings = controler.GenerateProgram(name + ".st")
            if errors or warnings or not text:
                raise ValueError(errors + warnings)
        except Exception:
            with open(name + ".err", "w", encoding="utf-8") as file:
                traceback.print_exc(file=file)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
