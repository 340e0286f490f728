// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.SEAR.view.link.RunnerLink;
import org.SEAR.view.link.WorldLink;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.lwjgl.glfw.GLFW;

/** The window stays hidden until its scene is drawn. */
@RunWith(UnderXvfb.class)
public class FirstPictureTest {
    private static boolean isVisible() {
        return GLFW.glfwGetWindowAttrib(GLFW.glfwGetCurrentContext(), GLFW.GLFW_VISIBLE) == GLFW.GLFW_TRUE;
    }

    @Test
    public void theWindowIsHiddenUntilTheSceneIsDrawn() throws Exception {
        List<Boolean> asked = Collections.synchronizedList(new ArrayList<>());
        try (RunningWorld world = new RunningWorld(ViewProjects.room())) {
            WorldLink link = new RunnerLink(world.runner, () -> false);
            WorldLink watched = (WorldLink) Proxy.newProxyInstance(WorldLink.class.getClassLoader(),
                new Class<?>[] {WorldLink.class}, (proxy, method, arguments) -> {
                    if (method.getName().equals("snapshot")) {
                        asked.add(isVisible());
                        return asked.size() < 10 ? null : link.snapshot();
                    }
                    return method.invoke(link, arguments);
                });
            List<Boolean> shown = Collections.synchronizedList(new ArrayList<>());
            WindowApplication window = WindowStart.open(watched, new WindowOptions(), () -> shown.add(isVisible()));
            assertNull(window.problem());
            try {
                assertEquals("without anything to draw", Collections.nCopies(10, false),
                    new ArrayList<>(asked.subList(0, 10)));
                assertEquals(List.of(true), shown);
                assertTrue(window.isOpen());
            } finally {
                window.close();
            }
        }
    }
}
