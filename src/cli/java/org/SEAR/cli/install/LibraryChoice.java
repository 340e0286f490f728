package org.SEAR.cli.install;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Which libraries of the distribution go into a MyRobotLab, and which it keeps of its own. Nothing is put there twice: what MyRobotLab has, in
 * whatever version, stays, unless the user wants its jMonkeyEngine replaced. Any one thread.
 */
final class LibraryChoice {
    /** Where MyRobotLab's jars are, in its folder. */
    static final String JARS = "libraries/jar/";
    /** Where the jars are kept that were replaced; no class path leads there. */
    static final String REPLACED = "libraries/sear-replaced/";
    /** jMonkeyEngine, and LWJGL below it, which belongs to it. */
    private static final Pattern ENGINE = Pattern.compile("(jme3|lwjgl)(-.*)?");
    /** What the window needs, by the first word of the library's name. */
    private static final Map<String, String> WINDOW_NEEDS = Map.of("jme3", "3.6", "lwjgl", "3.3");
    /** Optional reader of models; there is no newer one. */
    private static final String BLENDER = "jme3-blender";
    /** Older than ours, and known to do: MyRobotLab's develop of 2024 has it. */
    private static final Map<String, String> WORKS_FROM = Map.of("xstream", "1.4.19");

    private static final Comparator<String> NEWEST_FIRST = (a, b) -> Versions.compare(InstallPayload.version(b), InstallPayload.version(a));

    private final MrlFolder mrl;
    private final Receipt old;
    private final boolean replaceEngine;
    private String olderEngine;

    /**
     * @param old what is installed, or null
     * @param replaceEngine whether a jMonkeyEngine too old for the window makes room for ours
     */
    LibraryChoice(MrlFolder mrl, Receipt old, boolean replaceEngine) {
        this.mrl = mrl;
        this.old = old;
        this.replaceEngine = replaceEngine;
    }

    /**
     * Plans and says what becomes of each library.
     *
     * @param files takes the bytes to write, by path
     * @param receipt takes what is replaced
     */
    void choose(InstallPayload payload, InstallPlan plan, Map<String, byte[]> files, Receipt receipt) throws IOException, InstallException {
        Set<String> there = jarsOfMrl();
        Set<String> own = mrl.ownEntries();
        if (old != null) {
            receipt.replaced.putAll(old.replaced);
        }
        for (Path library : payload.libraries()) {
            String name = library.getFileName().toString();
            List<String> same = there.stream().filter(jar -> InstallPayload.artifact(jar).equals(InstallPayload.artifact(name))).sorted(NEWEST_FIRST)
                .collect(Collectors.toList());
            if (replaceEngine) {
                for (String jar : same.stream().filter(LibraryChoice::isTooOld).collect(Collectors.toList())) {
                    setAside(jar, plan, receipt);
                    same.remove(jar);
                }
            }
            if (!same.isEmpty()) {
                keep(same.get(0), name, plan);
            } else if (InstallPayload.isInside(library, own)) {
                plan.note("keep    " + name + ": myrobotlab.jar holds this library");
            } else {
                files.put(JARS + name, Files.readAllBytes(library));
            }
        }
    }

    /** Names of MyRobotLab's own jars. */
    private Set<String> jarsOfMrl() throws IOException {
        Set<String> names = new TreeSet<>();
        if (Files.isDirectory(mrl.jars())) {
            try (DirectoryStream<Path> jars = Files.newDirectoryStream(mrl.jars(), "*.jar")) {
                for (Path jar : jars) {
                    String name = jar.getFileName().toString();
                    if (old == null || !old.added.containsKey(JARS + name)) {
                        names.add(name);
                    }
                }
            }
        }
        return names;
    }

    private static boolean isTooOld(String jar) {
        String artifact = InstallPayload.artifact(jar);
        String needed = WINDOW_NEEDS.get(artifact.replaceAll("-.*", ""));
        return ENGINE.matcher(artifact).matches() && !artifact.equals(BLENDER) && Versions.compare(InstallPayload.version(jar), needed) < 0;
    }

    private void setAside(String jar, InstallPlan plan, Receipt receipt) throws IOException {
        byte[] bytes = Files.readAllBytes(mrl.jars().resolve(jar));
        plan.write(REPLACED + jar, bytes);
        plan.delete(JARS + jar);
        receipt.replaced.put(jar, Receipt.hash(bytes));
    }

    private void keep(String found, String ours, InstallPlan plan) {
        String theirs = InstallPayload.version(found);
        String version = InstallPayload.version(ours);
        if (isTooOld(found)) {
            olderEngine = olderEngine == null || found.startsWith("jme3-core") ? found : olderEngine;
            plan.note("keep    " + found + ", " + version + " would be ours: the window needs "
                + WINDOW_NEEDS.get(InstallPayload.artifact(found).replaceAll("-.*", "")) + "; --replace-jme puts ours into its place");
        } else if (theirs.equals(version)) {
            plan.note("keep    " + found + ": MyRobotLab has this library");
        } else {
            plan.note("keep    " + found + ", " + version + " would be ours: " + verdict(InstallPayload.artifact(found), theirs, version));
        }
    }

    private static String verdict(String artifact, String theirs, String ours) {
        String enough = WORKS_FROM.getOrDefault(artifact, WINDOW_NEEDS.get(artifact.replaceAll("-.*", "")));
        if (enough != null && Versions.compare(theirs, enough) >= 0) {
            return "works";
        }
        return Versions.compare(theirs, ours) > 0 ? "newer, should work" : "older, and SEAR was not tried with it";
    }

    /** A jar of a jMonkeyEngine that is kept and too old for the window; null if there is none. */
    String olderEngine() {
        return olderEngine;
    }

    /**
     * Plans to put back what was replaced.
     *
     * @param receipt of the installation that is taken out
     */
    static void putBack(MrlFolder mrl, Receipt receipt, InstallPlan plan) throws IOException {
        for (Map.Entry<String, String> jar : receipt.replaced.entrySet()) {
            Path kept = mrl.root().resolve(REPLACED + jar.getKey());
            if (!Files.exists(kept)) {
                plan.note("lost    " + JARS + jar.getKey() + ": it is no longer in " + REPLACED + "; MyRobotLab can install it again");
                continue;
            }
            if (!Files.exists(mrl.jars().resolve(jar.getKey()))) {
                plan.write(JARS + jar.getKey(), Files.readAllBytes(kept));
            }
            plan.delete(REPLACED + jar.getKey());
        }
    }
}
