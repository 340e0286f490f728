// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.xml;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.TreeMap;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Gravity;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.ObjectTypes;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Shape;

/**
 * All classes that may be the root element of an object's file: a robot, its drives, gravity, and the classes that
 * shapes ({@code physics.solid.Solids}), sensors and devices of SEAR and of other jars register. Immutable, any thread.
 */
public final class ObjectClasses {
    /** The robot, its drives and gravity; all other classes are registered with shapes, sensors and devices. */
    private static final List<Class<? extends SearObject>> OWN = List.of(SEARrobot.class, Dynamics.class, Motor.class,
        Servo.class, Led.class, Gravity.class);

    private final Map<String, Class<? extends SearObject>> byElement = new TreeMap<>();
    private final List<Class<? extends SearObject>> inOrder = new ArrayList<>();

    private ObjectClasses() {
        List<Class<? extends SearObject>> registered = new ArrayList<>();
        ClassLoader own = ObjectTypes.class.getClassLoader();
        ClassLoader context = Thread.currentThread().getContextClassLoader();
        ServiceLoader.load(ObjectTypes.class, own).forEach(more -> registered.addAll(more.types()));
        if (context != null && context != own) {
            ServiceLoader.load(ObjectTypes.class, context).forEach(more -> registered.addAll(more.types()));
        }
        registered.stream().filter(Shape.class::isAssignableFrom).forEach(this::add);
        OWN.forEach(this::add);
        registered.forEach(this::add);
    }

    /** Finds the classes; searches the class path on each call. */
    public static ObjectClasses find() {
        return new ObjectClasses();
    }

    private void add(Class<? extends SearObject> type) {
        Class<? extends SearObject> known = byElement.putIfAbsent(type.getSimpleName(), type);
        if (known == null) {
            inOrder.add(type);
        } else if (known != type) {
            throw new IllegalStateException("two classes want the element <" + type.getSimpleName() + ">: "
                + known.getName() + " and " + type.getName() + "; rename one of them");
        }
    }

    /**
     * Returns all classes: shapes, robots, their drives and gravity, sensors, devices. Each group is in the order of
     * registration.
     */
    public List<Class<? extends SearObject>> all() {
        return Collections.unmodifiableList(inOrder);
    }
}
