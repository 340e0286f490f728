// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import org.SEAR.POJOs.Box;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** Hostile bundles are rejected: nothing is written outside, and the old project stays unchanged. */
public class HostileBundleTest {
    private static final String BOX = "<Box><name>b</name><length>1</length><width>1</width><height>1</height></Box>";

    @Rule
    public final ProjectRule project = new ProjectRule();

    private final Map<String, byte[]> bundles = new LinkedHashMap<>();
    private final Map<String, String> expected = new LinkedHashMap<>();

    @Before
    public void haveAProject() {
        new Box("mine", 1, 1, 1, 0);
    }

    private void bundle(String what, RawZip zip, String message) {
        bundle(what, zip.bytes(), message);
    }

    private void bundle(String what, byte[] bytes, String message) {
        bundles.put(what, bytes);
        expected.put(what, message);
    }

    private RawZip with(String name) {
        RawZip zip = RawZip.bundle();
        zip.stored(name, BOX);
        return zip;
    }

    private void names() {
        String path = "legal: a path inside the project";
        bundle("leaves the folder", with("../evil.xml"), path);
        bundle("leaves the folder deep inside", with("environment/../../evil.xml"), path);
        bundle("absolute", with("/tmp/evil.xml"), path);
        bundle("drive", with("C:/evil.xml"), path);
        bundle("drive relative", with("C:evil.xml"), path);
        bundle("backslash", with("..\\evil.xml"), path);
        bundle("UNC", with("\\\\host\\share\\evil.xml"), path);
        bundle("empty part", with("environment//evil.xml"), path);
        bundle("single dot", with("environment/./evil.xml"), path);
        bundle("device name", with("environment/CON.xml"), path);
        bundle("alternate stream", with("environment/a.xml:evil"), path);
        bundle("trailing dot", with("environment/evil.xml."), path);
        bundle("zero byte", with("environment/a\0.xml"), path);
        bundle("hidden file", with(".ssh/authorized_keys"), path);
        bundle("very long name", with("assets/" + "a".repeat(300)), path);
        bundle("very deep", with("a/".repeat(50) + "b"), path);
        bundle("empty name", with(""), path);
        bundle("one folder too deep", with("SEARproject/environment/b.xml"), "legal: environment, robot and assets at "
            + "the top of the bundle");
        RawZip twice = with("environment/b.xml");
        twice.stored("environment/b.xml", BOX);
        bundle("twice", twice, "legal: each name once");
        RawZip capitals = with("environment/b.xml");
        capitals.stored("environment/B.xml", BOX);
        bundle("capitals", capitals, "differs from environment/b.xml by more than capitals");
        RawZip folders = with("assets/x.png");
        folders.stored("Assets/y.png", "");
        bundle("capitals of a folder", folders, "a folder that differs from assets");
        RawZip both = with("assets/x");
        both.stored("assets/x/y", "");
        bundle("file and folder", both, "a folder that isn't a file too");
        RawZip fileFirst = with("assets/x");
        fileFirst.stored("assets/x/", "");
        bundle("file and empty folder", fileFirst, "a folder that isn't a file too");
        RawZip folderFirst = RawZip.bundle();
        folderFirst.stored("assets/x/", "");
        folderFirst.stored("assets/x", "");
        bundle("empty folder and file", folderFirst, "a file that isn't a folder too");
        RawZip latin = RawZip.bundle();
        latin.stored(new byte[] {'a', (byte) 0xe9}, new byte[0]);
        bundle("not UTF-8", latin, "names in UTF-8");
    }

    private void foreignNames() {
        String path = "legal: a path inside the project";
        for (String name : new String[] {"../evil.xml", "SEARproject/../../evil.xml", "SEARproject/./evil.xml",
            "SEARproject//evil.xml", "/evil.xml",
            "SEARproject/environment/...", "C:/evil.xml"}) {
            RawZip zip = new RawZip();
            zip.stored("SEARproject/environment/b.xml", BOX);
            zip.stored(name, BOX);
            bundle("zipped by hand: " + name, zip, path);
        }
        RawZip windows = new RawZip();
        windows.stored("..\\evil.xml", BOX).madeBy(0);
        bundle("zipped by hand on Windows", windows, path);
        RawZip same = new RawZip();
        same.stored("environment/M\u00fcll.xml", BOX);
        same.stored("environment/Mu\u0308ll.xml", BOX);
        bundle("one name in two spellings", same, "legal: each name once");
        RawZip unmarked = RawZip.bundle();
        unmarked.stored("assets/M\u00fcll.txt", "x").flags(0);
        bundle("letters without a mark", unmarked, "a name in ASCII, or in UTF-8 and marked so");
    }

    private void structure() {
        RawZip link = RawZip.bundle();
        link.stored("assets/link", "/etc/passwd").unix(0xa1ff);
        bundle("symbolic link", link, "neither a link nor a device");
        RawZip device = RawZip.bundle();
        device.stored("assets/pipe", "").unix(0x11ff);
        bundle("named pipe", device, "neither a link nor a device");
        RawZip encrypted = RawZip.bundle();
        encrypted.stored("assets/secret", "x").flags(0x0801);
        bundle("encrypted", encrypted, "legal: not encrypted");
        RawZip method = RawZip.bundle();
        method.stored("assets/x", "x").method(14);
        bundle("LZMA", method, "stored or deflated; this has method 14");
        RawZip crc = RawZip.bundle();
        crc.stored("assets/x", "x").crc(1);
        bundle("wrong checksum", crc, "whole content; this is damaged");
        RawZip smuggled = RawZip.bundle();
        smuggled.stored("environment/ok.xml", BOX).localName("../../../ev.xml");
        bundle("another name at its place", smuggled, "the same in the directory and at its place");
        RawZip overlap = with("environment/b.xml");
        overlap.stored("environment/c.xml", BOX).offset(0);
        bundle("overlapping entries", overlap, "a place of its own");
        RawZip second = RawZip.bundle();
        second.stored("a", "x").extra(new byte[] {0x75, 0x70, 0, 0});
        bundle("second name", second, "without a second one in an extra record");
        RawZip zip64 = RawZip.bundle();
        zip64.stored("a", "x").extra(new byte[] {1, 0, 0, 0});
        bundle("zip64", zip64, "without zip64 records");
        byte[] good = with("environment/b.xml").bytes();
        bundle("cut off", Arrays.copyOf(good, good.length / 2), "no zip file, or cut off");
        bundle("no zip at all", "hello".getBytes(StandardCharsets.UTF_8), "no zip file, or cut off");
        byte[] trailing = Arrays.copyOf(good, good.length + 30);
        bundle("something behind the end", trailing, "no zip file, or cut off");
        byte[] prefixed = new byte[good.length + 10];
        System.arraycopy(good, 0, prefixed, 10, good.length);
        bundle("something before the start", prefixed, "directory is not where it should be");
    }

    private void bombs() throws IOException {
        RawZip bomb = RawZip.bundle();
        bomb.deflated("assets/zeros", new byte[20 << 20]);
        bundle("bomb", bomb, "compressed at most 200 times");
        RawZip liar = RawZip.bundle();
        liar.deflated("assets/zeros", new byte[1 << 20]).size(1000);
        bundle("bomb that says it is small", liar, "at most the 1000 bytes");
        RawZip huge = RawZip.bundle();
        huge.deflated("assets/huge", new byte[1000]).size(3L << 30);
        bundle("says it is huge", huge, "compressed at most 200 times");
        RawZip nested = RawZip.bundle();
        nested.stored("assets/inner.dat".getBytes(StandardCharsets.UTF_8), with("x").bytes());
        bundle("archive inside", nested, "no archive inside a bundle; this is zip");
        RawZip gzip = RawZip.bundle();
        gzip.stored("assets/a.gz", "\u001f\u008b\u0008\u0000");
        bundle("gzip inside", gzip, "no archive inside a bundle; this is gzip");
        RawZip many = RawZip.bundle();
        for (int i = 0; i < 20001; i++) {
            many.stored("assets/" + i, "");
        }
        bundle("too many entries", many, "at most 20000");
    }

    private void content() {
        RawZip none = new RawZip();
        none.stored("holidays/beach.txt", "sunny");
        bundle("any zip file", none, "it has no sear-version.txt and no object");
        RawZip newer = new RawZip();
        newer.stored("sear-version.txt", "2\n");
        bundle("from the future", newer, "a newer SEAR made this bundle");
        RawZip odd = new RawZip();
        odd.stored("sear-version.txt", "one");
        bundle("odd version", odd, "version is \"one\", legal: a whole number");
        RawZip broken = RawZip.bundle();
        broken.stored("environment/b.xml", BOX.replace("<length>1", "<length>-1"));
        bundle("an object that is wrong", broken, "environment/b.xml:1: length is \"-1\"");
        RawZip gadget = RawZip.bundle();
        gadget.stored("environment/b.xml",
            "<java.lang.ProcessBuilder><command><string>sh</string></command></java.lang.ProcessBuilder>");
        bundle("a foreign class", gadget, "<java.lang.ProcessBuilder> is not an object here");
        RawZip random = RawZip.bundle();
        byte[] noise = new byte[2000];
        new Random(7).nextBytes(noise);
        random.stored("environment/b.xml".getBytes(StandardCharsets.UTF_8), noise);
        bundle("noise", random, "environment/b.xml: it is not text in UTF-8");
    }

    @Test
    public void allAreRefusedWithNothingWrittenOutsideAndTheOldProjectIntact() throws Exception {
        names();
        foreignNames();
        structure();
        bombs();
        content();
        assertTrue(bundles.size() + " bundles", bundles.size() >= 20);
        Path places = project.newFolder("bundles").toPath();
        for (Map.Entry<String, byte[]> bundle : bundles.entrySet()) {
            Path file = places.resolve("b.sear");
            Files.write(file, bundle.getValue());
            Map<String, String> before = ProjectRule.files(project.getRoot().toPath());
            before.put(".SEARproject.lock", "");
            assertRefused(bundle.getKey(), file, expected.get(bundle.getKey()));
            assertEquals(bundle.getKey(), before, ProjectRule.files(project.getRoot().toPath()));
            assertEquals(bundle.getKey(), 0, emptyFolders(project.getRoot()));
        }
    }

    private static int emptyFolders(File root) {
        int empty = 0;
        for (File file : root.listFiles()) {
            if (file.isDirectory()) {
                empty += file.list().length == 0 ? 1 : emptyFolders(file);
            }
        }
        return empty;
    }

    private void assertRefused(String what, Path file, String message) throws IOException {
        try {
            Bundle.load(file, project.folder());
            fail(what + " was loaded");
        } catch (ProjectException e) {
            assertTrue(what + ": " + e.getMessage(), e.getMessage().contains(message));
        }
        try {
            Bundle.check(file);
            fail(what + " was found good");
        } catch (ProjectException e) {
            assertTrue(what + ": " + e.getMessage(), e.getMessage().contains(message));
        }
    }
}
