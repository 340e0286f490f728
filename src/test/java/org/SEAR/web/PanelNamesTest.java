// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.Test;

/**
 * MyRobotLab adds its own members to a panel's scope after the panel's controller ran. A panel that uses such a name
 * calls MyRobotLab's.
 */
public class PanelNamesTest {
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", "."));
    private static final List<Path> FOLDERS = List.of(ROOT.resolve("resources/resource/WebGui/app/service"),
        ROOT.resolve("src/mrl/resources/org/myrobotlab/embedded/pages/service"));
    private static final String TAKEN = "(?:save|release|apply|peer|showPeers|saveDefault|startPeer|releasePeer|"
        + "toggleVirtual|updateServiceData|servicedatajson|parentPanel)";
    private static final Pattern IN_SCRIPT = Pattern.compile("\\$scope(?:\\.|\\[')" + TAKEN + "\\b");
    private static final Pattern EXPRESSION = Pattern.compile("ng-[a-z-]+=\"([^\"]*)\"|\\{\\{(.*?)\\}\\}",
        Pattern.DOTALL);
    private static final Pattern IN_EXPRESSION = Pattern.compile("(?<![\\w$.])" + TAKEN + "\\b");

    private static List<String> scriptNames(String script) {
        return found(IN_SCRIPT, script);
    }

    private static List<String> viewNames(String view) {
        List<String> names = new ArrayList<>();
        Matcher matcher = EXPRESSION.matcher(view);
        while (matcher.find()) {
            String expression = matcher.group(1) == null ? matcher.group(2) : matcher.group(1);
            names.addAll(found(IN_EXPRESSION, expression.replaceAll("'[^']*'", "''")));
        }
        return names;
    }

    private static List<String> found(Pattern pattern, String text) {
        List<String> names = new ArrayList<>();
        Matcher matcher = pattern.matcher(text);
        while (matcher.find()) {
            names.add(matcher.group());
        }
        return names;
    }

    @Test
    public void noPanelUsesANameOfMyRobotLabForItsOwn() throws IOException {
        int panels = 0;
        for (Path folder : FOLDERS) {
            for (String type : new String[] {"SEAR", "LIDAR", "GPS", "Python", "Roomba", "Serial", "Any"}) {
                Path script = folder.resolve("js/" + type + "Gui.js");
                if (Files.exists(script)) {
                    panels++;
                    assertEquals(script.toString(), List.of(), scriptNames(Files.readString(script)));
                    assertEquals(type + "Gui.html", List.of(),
                        viewNames(Files.readString(folder.resolve("views/" + type + "Gui.html"))));
                }
            }
        }
        assertEquals(7, panels);
    }

    @Test
    public void suchNamesAreFound() {
        assertEquals(List.of("$scope.save", "$scope['peer"),
            scriptNames("$scope.save = f; $scope['peer'] = 1; $scope.saveProject = g; msg.save()"));
        assertEquals(List.of("save", "showPeers", "servicedatajson"),
            viewNames("<p title=\"save\" ng-click=\"save()\" ng-if=\"a || showPeers\">"
            + "{{ 1 + servicedatajson }} {{'peer'}} {{robot.peer}} save <b ng-click=\"msg.release(); "
                + "saveProject()\">"));
    }
}
