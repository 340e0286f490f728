// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * {@code sear install MRL_FOLDER [--remove] [--dry-run]}. Exit status 0, or 1 with a message if nothing was changed.
 */
@Command(name = "install", mixinStandardHelpOptions = true,
    description = "Installs or updates SEAR in a MyRobotLab: plug-in, libraries, panels and service picker entries; or "
        + "removes them.")
public final class InstallCommand implements Callable<Integer> {
    @Parameters(paramLabel = "MRL_FOLDER", description = "The folder with myrobotlab.jar.")
    private Path folder;
    @Option(names = "--remove", description = "Remove exactly what was installed.")
    private boolean remove;
    @Option(names = "--replace-jme", description = "Replace MyRobotLab's jMonkeyEngine if it is too old for the "
        + "window, which needs 3.6; --remove restores it.")
    private boolean replaceEngine;
    @Option(names = "--dry-run", description = "Only print what would be done.")
    private boolean dryRun;
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        PrintWriter out = spec.commandLine().getOut();
        try {
            Installer installer = new Installer(folder);
            String home = System.getProperty("sear.home"); // set by the start script
            if (home == null) {
                throw new InstallException("Start this command as bin/sear of the distribution (./gradlew installDist "
                    + "creates one).");
            }
            InstallPlan plan = remove ? installer.remove() : installer.install(Path.of(home, "plugin"), replaceEngine);
            String version = "SEAR " + installer.old.version;
            out.println("MyRobotLab: " + installer.mrl.root
                + (installer.old.version == null ? "" : ", with " + version));
            if (installer.recovered != null) {
                out.println(installer.recovered);
            }
            plan.notes.forEach(line -> out.println("  " + line));
            if (plan.isEmpty()) {
                out.println(plan.remarks.isEmpty() ? "Nothing to do: " + version + " is installed and complete."
                    : "Nothing to do now: " + version + " is installed.");
            } else if (dryRun) {
                out.println("Nothing was changed (--dry-run).");
            } else {
                plan.apply();
                out.println(remove ? "SEAR was removed." : "Done. Start MyRobotLab; " + (plan.remarks.isEmpty()
                    ? "SEAR, LIDAR and GPS are among its services." : "SEAR, LIDAR and GPS can be started."));
            }
            plan.remarks.forEach(out::println);
            return 0;
        } catch (InstallException e) {
            spec.commandLine().getErr().println("sear install: " + e.getMessage());
        } catch (IOException e) {
            spec.commandLine().getErr().println(
                "sear install: " + e + (e.getSuppressed().length == 0 ? ". Everything is as it was before."
                : ". Restoring the old files failed as well: " + Arrays.toString(e.getSuppressed())));
        }
        return 1;
    }
}
