package org.SEAR.cli.install;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.myrobotlab.service.link.PanelFiles;

/**
 * Which libraries of the distribution go into a MyRobotLab, and which it keeps of its own. Nothing is put there twice: what MyRobotLab has, in
 * whatever version, stays, unless the user wants its jMonkeyEngine replaced. Any one thread.
 */
final class LibraryChoice {
    /** Where MyRobotLab's jars are, in its folder. */
    static final String JARS = "libraries/jar/";
    /** Where the jars are kept that were replaced; no class path leads there. */
    private static final String REPLACED = "libraries/sear-replaced/";
    /** Older than ours, and known to do: MyRobotLab's develop of 2024 has it. */
    private static final Map<String, String> WORKS_FROM = Map.of("xstream", "1.4.19");

    private final InstallPlan plan;
    private final Receipt receipt;
    private String olderEngine;

    /** @param receipt takes, or has, what is replaced */
    LibraryChoice(InstallPlan plan, Receipt receipt) {
        this.plan = plan;
        this.receipt = receipt;
    }

    /**
     * Says what becomes of each library.
     *
     * @param libraries of the distribution
     * @param there MyRobotLab's own jars
     * @param own names of the entries in {@code myrobotlab.jar}: a library whose classes are in there is not added again
     * @param replaceEngine whether a jMonkeyEngine too old for the window makes room for ours
     * @return the bytes to write, by path
     */
    Map<String, byte[]> choose(List<Path> libraries, List<JarName> there, Set<String> own, boolean replaceEngine) throws IOException {
        Map<String, byte[]> files = new TreeMap<>();
        for (Path library : libraries) {
            JarName ours = new JarName(library);
            List<JarName> same = there.stream().filter(jar -> jar.artifact.equals(ours.artifact))
                .sorted(Comparator.comparing((JarName jar) -> jar.version, JarName::compare).reversed()).collect(Collectors.toList());
            while (replaceEngine && !same.isEmpty() && same.get(same.size() - 1).isTooOldForTheWindow()) {
                setAside(same.remove(same.size() - 1).name);
            }
            if (!same.isEmpty()) {
                keep(same.get(0), ours);
            } else if (isInside(library, own)) {
                plan.notes.add("keep    " + ours.name + ": myrobotlab.jar holds this library");
            } else {
                files.put(JARS + ours.name, Files.readAllBytes(library));
            }
        }
        return files;
    }

    private static boolean isInside(Path library, Set<String> own) throws IOException {
        try (ZipFile jar = new ZipFile(library.toFile())) {
            return jar.stream().map(ZipEntry::getName).filter(name -> name.endsWith(".class") && !name.contains("-info"))
                .findFirst().map(own::contains).orElse(false);
        }
    }

    private void setAside(String jar) throws IOException {
        byte[] bytes = plan.now(JARS + jar);
        plan.write(REPLACED + jar, bytes);
        plan.write(JARS + jar, null);
        receipt.replaced.put(jar, PanelFiles.hash(bytes));
    }

    private void keep(JarName found, JarName ours) {
        if (found.isTooOldForTheWindow() && (olderEngine == null || found.artifact.equals("jme3-core"))) {
            olderEngine = found.name;
        }
        plan.notes.add("keep    " + found.name + (found.version.equals(ours.version) ? ": MyRobotLab has this library"
            : ", " + ours.version + " would be ours: " + verdict(found, ours)));
    }

    private static String verdict(JarName found, JarName ours) {
        if (found.isTooOldForTheWindow()) {
            return "the window needs " + found.neededVersion() + "; --replace-jme puts ours into its place";
        }
        String enough = WORKS_FROM.getOrDefault(found.artifact, found.neededVersion());
        if (enough != null && JarName.compare(found.version, enough) >= 0) {
            return "works";
        }
        return JarName.compare(found.version, ours.version) > 0 ? "newer, should work" : "older, and SEAR was not tried with it";
    }

    /** A jar of a jMonkeyEngine that is kept and too old for the window; null if there is none. */
    String olderEngine() {
        return olderEngine;
    }

    /** Plans to put back what was replaced. */
    void putBack() throws IOException {
        for (String jar : receipt.replaced.keySet()) {
            byte[] kept = plan.now(REPLACED + jar);
            if (kept == null) {
                plan.notes.add("lost    " + JARS + jar + ": it is no longer in " + REPLACED + "; MyRobotLab can install it again");
                continue;
            }
            if (plan.now(JARS + jar) == null) {
                plan.write(JARS + jar, kept);
            }
            plan.write(REPLACED + jar, null);
        }
    }
}
