// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.lang.management.ManagementFactory;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/**
 * Runs the scenes of bodies and prints each measured value beside its expected one. {@code ./gradlew bodyReport} runs
 * all; {@code -Pscenes="drops pile top"} runs those whose names begin with one of these words.
 */
public final class BodyReport {
    /** A scene or a group of similar scenes. */
    interface Scene {
        void play(Findings into) throws Exception;
    }

    private BodyReport() {
    }

    /** Returns all scenes by name. */
    static Map<String, Scene> scenes() {
        Map<String, Scene> all = new LinkedHashMap<>();
        for (int seed = 1; seed <= 3; seed++) {
            int number = seed;
            all.put("drops" + seed, into -> DropScenes.single(Integer.getInteger("sear.singles", 1000), number, into));
        }
        all.put("landing", into -> DropScenes.landing(300, into));
        all.put("pile100", into -> DropScenes.pile(100, 1, into));
        all.put("pile1000", into -> DropScenes.pile(1000, 1, into));
        for (double height : DominoScenes.HEIGHTS) {
            for (double gap : DominoScenes.GAPS) {
                all.put("dominoes" + height + "/" + gap, into -> DominoScenes.row(height, gap, into));
            }
        }
        all.put("stack", StackScenes::ten);
        all.put("forty", StackScenes::forty);
        all.put("mass1000on1", into -> StackScenes.masses(1, 1000, into));
        all.put("mass1on1000", into -> StackScenes.masses(1000, 1, into));
        all.put("massdropped", StackScenes::dropOntoLight);
        for (double degrees : new double[] {5, 15, 30}) {
            all.put("ball" + degrees, into -> RollingScenes.ball(degrees, 3, into));
            all.put("cylinder" + degrees, into -> RollingScenes.cylinder(degrees, 3, into));
            all.put("cone" + degrees, into -> RollingScenes.cone(degrees, into));
        }
        all.put("tumblingbox", SpinScenes::tumblingBox);
        all.put("tumblingT", SpinScenes::tumblingT);
        all.put("tumblingL", SpinScenes::tumblingL);
        all.put("rod", SpinScenes::nutatingRod);
        all.put("disc", SpinScenes::wobblingDisc);
        all.put("top", SpinScenes::top);
        for (double gap : new double[] {0, 0.001}) {
            all.put("cradle1/" + gap, into -> ImpactScenes.cradle(1, gap, into));
            all.put("cradle2/" + gap, into -> ImpactScenes.cradle(2, gap, into));
        }
        all.put("pole1", into -> BalanceScenes.pole(0.05, 1, into));
        all.put("pole3", into -> BalanceScenes.pole(0.15, 3, into));
        all.put("slightslope", BalanceScenes::ball);
        all.put("wakefar", into -> WakeScenes.support(5, 0, 0.1, into));
        all.put("wakedown", into -> WakeScenes.support(0, -0.1, 0.4, into));
        all.put("wakeup", into -> WakeScenes.support(0, 0.05, 0.55, into));
        all.put("wakelowest", WakeScenes::lowest);
        all.put("wakehit", WakeScenes::hit);
        all.put("crowd200", into -> CrowdScenes.oneSpot(200, into));
        all.put("block2000", into -> CrowdScenes.block(2000, into));
        return all;
    }

    private static boolean isWanted(String name, String[] words) {
        for (String word : words) {
            if (name.startsWith(word)) {
                return true;
            }
        }
        return words.length == 0;
    }

    public static void main(String[] words) {
        Findings all = new Findings();
        int failed = 0;
        for (Map.Entry<String, Scene> scene : scenes().entrySet()) {
            if (!isWanted(scene.getKey(), words)) {
                continue;
            }
            int from = all.list().size();
            long before = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
            try {
                scene.getValue().play(all);
            } catch (Exception | AssertionError e) {
                all.in(scene.getKey()).equal("ended early: " + e, 0, 1);
            }
            double seconds = (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - before) * 1e-9;
            System.out.printf(Locale.ROOT, "-- %s: %.2f CPU s%n", scene.getKey(), seconds);
            for (Findings.Finding finding : all.list().subList(from, all.list().size())) {
                System.out.println(finding.row());
                failed += finding.holds() ? 0 : 1;
            }
        }
        System.out.printf(Locale.ROOT, "%d of %d values do not hold%n", failed, all.list().size());
    }
}
