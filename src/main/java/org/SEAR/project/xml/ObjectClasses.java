package org.SEAR.project.xml;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.TreeMap;
import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Bumper;
import org.SEAR.POJOs.ColorSensor;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.IMU;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.LineSensor;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.ObjectTypes;
import org.SEAR.POJOs.Odometer;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Shape;

/** All classes that may stand as root element in an object's file: the grammar's own, shapes as {@code physics.solid.Solids}
 * lists them, and those that other jars register. Immutable, any thread. */
public final class ObjectClasses {
    private static final List<Class<? extends SearObject>> OWN = List.of(SEARrobot.class, Dynamics.class, Motor.class, Servo.class, Led.class,
        Distance.class, LIDAR.class, GPS.class, Compass.class, Accelerometer.class, Gyroscope.class, Odometer.class, IMU.class, LineSensor.class,
        ColorSensor.class, Bumper.class, Arduino.class);

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

    /** All classes: shapes, then the grammar's other ones, then those of other jars. */
    public List<Class<? extends SearObject>> all() {
        return Collections.unmodifiableList(inOrder);
    }
}
