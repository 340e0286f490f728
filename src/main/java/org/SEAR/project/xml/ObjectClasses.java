package org.SEAR.project.xml;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.TreeMap;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.ObjectTypes;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Shape;

/**
 * All classes that may stand as root element in an object's file: a robot and its drive, and those that shapes ({@code physics.solid.Solids}), kinds
 * of sensors and kinds of devices register, SEAR's own and those of other jars. Immutable, any thread.
 */
public final class ObjectClasses {
    /** A robot and what moves it. All else is registered by what makes something of it: shapes, sensors, devices. */
    private static final List<Class<? extends SearObject>> OWN = List.of(SEARrobot.class, Dynamics.class, Motor.class, Servo.class, Led.class);

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

    /** The classes that there are now; looks at the class path again each time. */
    public static ObjectClasses find() {
        return new ObjectClasses();
    }

    private void add(Class<? extends SearObject> type) {
        Class<? extends SearObject> known = byElement.putIfAbsent(type.getSimpleName(), type);
        if (known == null) {
            inOrder.add(type);
        } else if (known != type) {
            throw new IllegalStateException("two classes want the element <" + type.getSimpleName() + ">: " + known.getName() + " and "
                + type.getName() + "; rename one of them");
        }
    }

    /** All classes: shapes, robots and what moves them, sensors, devices that are nothing else, each kind in the order in which it is registered. */
    public List<Class<? extends SearObject>> all() {
        return Collections.unmodifiableList(inOrder);
    }
}
