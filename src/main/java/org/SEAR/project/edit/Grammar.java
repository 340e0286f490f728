// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Gravity;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Walls;
import org.SEAR.POJOs.Wheel;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;
import org.SEAR.project.ObjectDocs;
import org.SEAR.project.xml.ObjectClasses;

/**
 * The object grammar as maps, lists, texts and numbers for JSON, from the classes that read and check the files. Any
 * thread.
 *
 * <pre>
 * [{"type": "Box", "doc": "a box: ..", "kind": "shape" ("sensor", "robot", "joint", "part" or "world"),
 *   "environment": true, "robot": true (where it is legal),
 *   "parameters": [{"name": "length", "doc": "size along x", "unit": "m", "kind": "number" ("whole", "switch", "text",
 * "group"),
 *                   "legal": "a number from ..", "min": 0.0001, "max": 100000, "orZero": false, "values": [], "words":
 * [] (meanings of the values),
 *                   "names": "" ("Wheel": class of the part of the same robot that it names), "drawing": false
 * (whether its entries are lines of a drawing by characters),
 *                   "required": true, "list": false, "most": 1, "default": "", "initial": "0.5" (for an object that is
 * created with the mouse; of a list one entry per line),
 *                   "parameters": [..] (of a group)}, ..]}, ..]
 * </pre>
 */
public final class Grammar {
    private Grammar() {
    }

    /** Returns all classes of which objects can be created, shapes first. */
    public static List<Map<String, Object>> types() {
        List<Map<String, Object>> types = new ArrayList<>();
        for (Class<? extends SearObject> type : ObjectClasses.find().all()) {
            Map<String, Object> map = new LinkedHashMap<>();
            map.put("type", type.getSimpleName());
            map.put("doc", ObjectDocs.description(type));
            map.put("kind", kind(type));
            map.put("environment", standsInEnvironment(type));
            map.put("robot", standsOnRobot(type));
            map.put("parameters", parameters(type));
            types.add(map);
        }
        return types;
    }

    private static String kind(Class<? extends SearObject> type) {
        if (type == SEARrobot.class) {
            return "robot";
        }
        if (Joint.class.isAssignableFrom(type)) {
            return "joint";
        }
        if (type == Gravity.class) {
            return "world";
        }
        return SensorObject.class.isAssignableFrom(type) ? "sensor" : Shape.class.isAssignableFrom(type)
            && type != Wheel.class ? "shape" : "part";
    }

    /** Returns whether an object of a class may be part of the environment. */
    static boolean standsInEnvironment(Class<? extends SearObject> type) {
        return Shape.class.isAssignableFrom(type) && type != Wheel.class || Joint.class.isAssignableFrom(type)
            || type == Gravity.class;
    }

    /** Returns whether an object of a class may be a part of a robot. */
    static boolean standsOnRobot(Class<? extends SearObject> type) {
        return type != Floor.class && type != Terrain.class && !Walls.class.isAssignableFrom(type)
            && type != SEARrobot.class && type != Gravity.class;
    }

    /** Returns the unit of a parameter; joints with one class for several kinds have that of a hinge first. */
    static String unit(Class<?> type, Parameter parameter) {
        String[] units = parameter.getUnit().split(" or ");
        return units.length == 1 || Hinge.class.isAssignableFrom(type) ? units[0] : units[1];
    }

    private static List<Map<String, Object>> parameters(Class<?> type) {
        ParameterTable table = ParameterTable.of(type);
        List<Map<String, Object>> all = new ArrayList<>();
        for (Parameter parameter : table.getParameters()) {
            Map<String, Object> map = new LinkedHashMap<>();
            map.put("name", parameter.getName());
            map.put("doc", parameter.getDoc());
            map.put("unit", unit(type, parameter));
            map.put("kind", parameter.getKind().name().toLowerCase(Locale.ROOT));
            map.put("legal", parameter.legal());
            map.put("min", parameter.getMin());
            map.put("max", parameter.getMax());
            map.put("orZero", parameter.isOrZero());
            map.put("values", parameter.getValues());
            map.put("words", parameter.getWords());
            map.put("names", parameter.getNamed());
            map.put("drawing", parameter.getTextRule() == TextRule.DRAWING);
            map.put("required", parameter.isRequired());
            map.put("list", parameter.isList());
            map.put("most", parameter.getMaxEntries());
            boolean group = parameter.getKind() == Parameter.Kind.GROUP;
            map.put("default", group ? "" : table.defaultOf(parameter));
            map.put("initial", parameter.getInitial());
            if (group && parameter.getType() != Wheel.class) {
                map.put("parameters", parameters(parameter.getType()));
            }
            all.add(map);
        }
        return all;
    }
}
