// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.framework.Talker;

/** Python scripts in the embedded MyRobotLab. */
public class PythonTest {
    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private Python python;
    private Talker talker;

    @Before
    public void start() {
        python = (Python) Runtime.start("python", "Python");
        talker = (Talker) Runtime.start("talker", Talker.class.getName());
    }

    @After
    public void release() {
        Runtime.releaseAll();
    }

    private void until(String expression) {
        assertTrue(expression + " never came true", python.exec("import time\nend = time.time() + 60\n"
            + "while not (" + expression + ") and time.time() < end: time.sleep(0.005)\nassert " + expression));
    }

    @Test
    public void globalsAreThoseOfMyRobotLab() {
        assertTrue(python.exec("assert python.name == python.getName() == 'python'\n"
            + "assert Runtime.getService('python') is python\n"
            + "assert Platform.getLocalInstance() and Service and Python and sys.version_info[0] == 2\nsleep(0.001)"));
    }

    @Test
    public void aCallBeforeTheStartIsCompleteSaysSo() {
        Python late = (Python) Runtime.create("late", "Python");
        for (ThrowingRunnable call : new ThrowingRunnable[] {() -> late.exec("1"), () -> late.exec("1", false),
            () -> late.execMethod("f"),
            () -> late.get("a")}) {
            assertEquals("late is starting: try again in a moment", assertThrows(IllegalStateException.class,
                call).getMessage());
        }
        assertFalse(late.stop());
        late.startService();
        assertTrue(late.exec("1"));
        late.releaseService();
        assertEquals("late has been released: start it again", assertThrows(IllegalStateException.class,
            () -> late.exec("1")).getMessage());
    }

    /** A list of the 25,000 files of its jar would take a tenth of a script's start time. */
    @Test
    public void pythonsOwnModulesAreFoundWithoutAListOfItsJar() {
        assertTrue(python.exec("import json, threading, xml.dom.minidom, encodings.idna\n"
            + "assert json.loads('[1]') == [1]\nassert [one for one in sys.path if one.endswith('.jar/Lib')] == []\n"
            + "lists = [one for one in sys.path_importer_cache if '.jar' in one]\nassert lists == [], lists"));
    }

    @Test
    public void aNewServiceIsAVariableAndAClassAMomentLater() {
        assertTrue(python.exec("made = Runtime.createAndStart('wire', 'Serial')\nassert made.name == 'wire'"));
        until("'wire' in globals() and 'Serial' in globals()");
        assertTrue(python.exec("assert wire is made and Serial.BAUD_9600 == 9600"));
        Runtime.release("wire");
        until("'wire' not in globals()");
    }

    @Test
    public void functionsAreCalledBackOneAfterAnother() {
        assertTrue(python.exec("got = []\ndef input(data):\n  got.append(data)\ndef second(data):\n  "
            + "got.append(list(data))\ntalker = Runtime.getService('talker')\n"
            + "talker.addListener('publishNumber', python.name, 'input')\ntalker.addListener('publishArray', "
                + "python.name, 'second')"));
        for (int i = 0; i < 200; i++) {
            talker.invoke("publishNumber", i);
        }
        talker.invoke("publishArray", (Object) new int[] {4, 5});
        until("got == range(200) + [[4, 5]]");
    }

    @Test
    public void aCallbackDoesNotEndTheLineThatTheScriptPrints() {
        assertTrue(python.exec("import time\nclass Out:\n  text = ''\n  softspace = 0\n  def write(self, part): "
            + "self.text += part\n"
            + "got = []\ndef input(data):\n  got.append(data)\ntalker = Runtime.getService('talker')\n"
            + "talker.addListener('publishNumber', python.name, 'input')\ndef called():\n  end = time.time() + 60\n"
            + "  talker.invoke('publishNumber', 1)\n  talker.invoke('publishNumber', 2)\n"
            + "  while got != [1, 2] and time.time() < end: time.sleep(0.005)\n  return got\n"
            + "console, out = sys.stdout, Out()\nsys.stdout = out\ntry:\n  print 'got', called()\nfinally:\n  "
            + "sys.stdout = console\nassert out.text == 'got [1, 2]\\n', out.text"));
    }

    @Test
    public void bytesOfAPortAreNumbersFrom0To255() throws Exception {
        Serial uart = Serial.connectVirtualUart("/dev/py");
        assertTrue(python.exec("got = []\nchunks = []\ndef input(data):\n  got.append(data)\ndef piece(data):\n  "
            + "chunks.extend(data)\n"
            + "port = Runtime.start('port', 'Serial')\nport.addListener('publishRX', python.name, 'input')\n"
            + "port.addListener('publishBytes', python.name, 'piece')\nport.connect('/dev/py', 9600, 8, 1, 0)"));
        uart.write(new byte[] {0, 127, -128, -1});
        until("got == [0, 127, 128, 255] and chunks == [0, 127, -128, -1]");
        uart.setTimeout(60_000);
        assertTrue(python.exec("port.write(511)\nport.write('ab')"));
        assertEquals("\u00ffab", new String(uart.read(3), StandardCharsets.ISO_8859_1));
    }

    @Test
    public void aFileMayBeginWithAByteOrderMark() throws Exception {
        for (String code : new String[] {"x = 1\r\n", "# coding: utf-8\r\nx = u'\u00fc'\r\n", "x = u'\u65e5'\r\n"}) {
            Path script = folder.newFile().toPath();
            Files.writeString(script, "\ufeff" + code);
            assertTrue(code, python.execFile(script.toString()));
        }
        assertTrue(python.exec("assert x == u'\\u65e5'"));
    }

    @Test
    public void anErrorShowsTheTracebackWithFileAndLine() throws Exception {
        Path script = folder.newFile("wrong.py").toPath();
        Files.writeString(script, "# \u00e4\ndef f():\n    return 1 / 0\n\nf()\n");
        talker.subscribe("python", "publishStdError", "onReleased");
        assertFalse(python.execFile(script.toString()));
        String traceback = python.getLastError().key;
        assertEquals("Traceback (most recent call last):\n  File \"" + script + "\", line 5, in <module>\n    "
            + "f()\n  File \"" + script
            + "\", line 3, in f\n    return 1 / 0\nZeroDivisionError: integer division or modulo by zero", traceback);
        assertEquals("released " + traceback + "\n", talker.heard.poll(60, TimeUnit.SECONDS));
        assertFalse(python.exec("if True print 1"));
        assertTrue(python.getLastError().key, python.getLastError().key.contains("SyntaxError"));
        assertFalse(python.exec("Runtime.getService('talker').fail()"));
        assertTrue(python.getLastError().key, python.getLastError().key.endsWith("IllegalStateException: no good"));
    }

    @Test
    public void aCallbackThatRaisesIsAnErrorAndTheNextIsCalled() {
        assertTrue(python.exec("got = []\ndef input(data):\n  got.append(data)\n  if data == 1: raise "
            + "ValueError('one')\nRuntime.getService('talker').addListener('publishNumber', python.name, 'input')"));
        talker.invoke("publishNumber", 1);
        talker.invoke("publishNumber", 2);
        until("got == [1, 2]");
        assertTrue(python.getLastError().key.endsWith("ValueError: one"));
    }

    @Test
    public void aCallbackWithoutFunctionIsReported() throws InterruptedException {
        talker.subscribe("python", "publishError", "onStatus");
        talker.addListener("publishNumber", "python", "nix");
        talker.invoke("publishNumber", 1);
        assertEquals("python error talker.publishNumber calls back nix, but the script has no function of that name",
            talker.heard.poll(60, TimeUnit.SECONDS).toString());
    }

    @Test
    public void outputOfScriptsIsPublishedByLine() throws InterruptedException {
        talker.subscribe("python", "publishStdOut", "onReleased");
        assertTrue(python.exec("print 'one', 2\nprint u'\u00fc'"));
        assertEquals("released one 2\n", talker.heard.poll(60, TimeUnit.SECONDS));
        assertEquals("released \u00fc\n", talker.heard.poll(60, TimeUnit.SECONDS));
    }

    @Test
    public void threadsMayPrintAtTheSameTime() {
        assertTrue(python.exec("import threading\nwrong = []\ndef many():\n  try:\n    for i in range(2000): print "
            + "'line', i, u'\u00fc'\n  except Exception, e: wrong.append(e)\n"
            + "threads = [threading.Thread(target=many) for i in range(4)]\nfor t in threads: t.start()\nfor t in "
            + "threads: t.join()\nassert wrong == [], wrong\nsys.stdout.writelines(['a', "
                + "u'b'])\nsys.stdout.flush()\nsys.stderr.write('c\\n')"));
    }

    @Test(timeout = 120_000)
    public void stopAbortsEndlessLoopsAndSleeps() throws InterruptedException {
        for (String endless : new String[] {"while True: n = 1", "sleep(1000)"}) {
            CountDownLatch ended = new CountDownLatch(1);
            python.set("begun", false);
            Thread thread = new Thread(() -> {
                python.exec("begun = True\n" + endless);
                ended.countDown();
            });
            thread.start();
            until("begun");
            while (!ended.await(10, TimeUnit.MILLISECONDS)) {
                python.stop();
            }
            assertFalse(String.valueOf(python.getLastError()), python.hasError());
        }
        assertTrue(python.exec("alive = 1"));
    }

    @Test
    public void anErrorShowsLettersThatAreNotAscii() throws Exception {
        Path script = folder.newFile("umlaut.py").toPath();
        for (String error : new String[] {"ValueError(u'T\u00fcr?')", "ValueError('T\u00fcr?')",
            "IOError(u'T\u00fcr?')"}) {
            Files.writeString(script, "# coding: utf-8\nname = 'K\u00e4fer \ud83d\ude00'; raise " + error + "\n");
            assertFalse(python.execFile(script.toString()));
            assertEquals("Traceback (most recent call last):\n  File \"" + script + "\", line 2, in <module>\n    name "
                + "= 'K\u00e4fer \ud83d\ude00';"
                + " raise " + error + "\n" + error.substring(0, error.indexOf('(')) + ": T\u00fcr?",
                    python.getLastError().key);
        }
    }

    @Test
    public void aFileImportsFromItsOwnFolder() throws Exception {
        Files.writeString(folder.newFile("helper_of_test.py").toPath(), "value = 42\n");
        Path script = folder.newFile("main.py").toPath();
        Files.writeString(script, "import helper_of_test\nresult = helper_of_test.value\nassert __name__ == '__main__' "
            + "and __file__\n");
        assertTrue(python.execFile(script.toString()));
        assertEquals(42, python.get("result"));
        assertFalse(python.execFile(folder.getRoot() + "/nix.py"));
        assertTrue(python.getLastError().key.endsWith("nix.py can't be read: there is no such file"));
    }

    @Test
    public void theEditorOpensAndSavesScripts() throws Exception {
        python.getConfig().scriptRootDir = folder.getRoot().toString();
        IOException missing = assertThrows(IOException.class, () -> python.saveScript("sub/a.py", "x = 1\n"));
        assertEquals("sub/a.py can't be saved: there is no folder " + folder.getRoot().toPath().resolve("sub")
            + "; create it first", missing.getMessage());
        folder.newFolder("sub");
        python.saveScript("sub/a.py", "x = 1\n");
        assertEquals("x = 1\n", Files.readString(folder.getRoot().toPath().resolve("sub/a.py")));
        python.openScript("sub/a.py");
        assertEquals("[sub/a.py]", python.getScriptList().toString());
        assertEquals("x = 1\n", python.openedScripts.get("sub/a.py").code);
        python.closeScript("sub/a.py");
        assertTrue(python.openedScripts.isEmpty());
    }

    @Test
    public void allObjectsAreImportedTogether() {
        assertTrue(python.exec("from org.SEAR.POJOs import Cone\nfrom org.SEAR.POJOs import *\nimport "
            + "org.SEAR.POJOs.Floor\nassert str(Box) == \"<type 'org.SEAR.POJOs.Box'>\"\nassert Cone and SEARrobot and "
                + "org.SEAR.POJOs.Floor\n"));
    }

    @Test
    public void theModuleTimeIsComplete() {
        assertTrue(python.exec("from time import *\nimport time, java\nstart = "
            + "java.lang.System.nanoTime()\ntime.sleep(0.05)\nsleep(0.05)\n"
            + "assert java.lang.System.nanoTime() - start > 90e6\n"
            + "assert clock and strftime('%Y', gmtime(0)) == '1970' and timezone == time.timezone"));
    }

    @Test
    public void inLockStepNoSleepOfMyRobotLabLetsSimulatedTimePass() {
        System.setProperty("sear.headless", "true");
        TestWorld.build(folder.getRoot().toPath());
        try {
            assertTrue(python.exec(String.join("\n", "import time", "sear = Runtime.start('sear', 'SEAR')",
                "sear.setLockStep(True)",
                "sear.startSimulation()", "roomba = Runtime.start('roomba', 'Roomba')", "roomba.connect('"
                + TestWorld.ROOMBA_PORT + "')",
                "start = sear.getTime()", "for wait in (lambda: sleep(0.05), lambda: time.sleep(0.05), lambda: "
                + "roomba.sleep(50),", "        lambda: roomba.goForward(10), lambda: roomba.spin(5)):", "    wait()",
                "assert sear.getTime() == start",
                "sear.simSleep(0.5)", "assert abs(sear.getTime() - start - 0.5) < 0.02", "sear.stopSimulation()", "")));
        } finally {
            System.clearProperty("sear.project");
        }
    }

    @Test
    public void aCharacterUnknownToPythonIsAnErrorInTheTab() {
        python.exec("errors = []\ndef onStdError(text): errors.append(text)\npython.addListener('publishStdError', "
            + "'python', 'onStdError')");
        assertFalse(python.exec("print \u201chi\u201d"));
        until("len(errors) == 1");
        assertTrue(python.exec("assert 'U+201C' in errors[0] and 'line 1' in errors[0], errors"));
    }
}
