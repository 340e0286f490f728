// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.codec;

import java.util.Objects;
import org.myrobotlab.embedded.Json;
import org.myrobotlab.embedded.Registry;
import org.myrobotlab.embedded.Yaml;

/** Service names, callback names and objects as JSON or YAML. Any thread. */
public class CodecUtils {
    private static final String PUBLISH = "publish";
    private static final String GET = "get";
    private static final String SERVICES = "org.myrobotlab.service.";

    /** Returns the name without the process id. */
    public static String getShortName(String name) {
        int at = name == null ? -1 : name.indexOf('@');
        return at < 0 ? name : name.substring(0, at);
    }

    /** Returns the name with the process id: {@code name@id}. */
    public static String getFullName(String name) {
        return name == null || name.indexOf('@') >= 0 ? name : name + "@" + Registry.ID;
    }

    /** Returns the process id of a full name; null for a short name. */
    public static String getId(String name) {
        int at = name == null ? -1 : name.indexOf('@');
        return at < 0 ? null : name.substring(at + 1);
    }

    public static boolean checkServiceNameEquality(String a, String b) {
        return Objects.equals(getFullName(a), getFullName(b));
    }

    public static boolean isLocal(String name) {
        String id = getId(name);
        return id == null || id.equals(Registry.ID);
    }

    /** Returns the callback for a published method: {@code publishX} and {@code getX} become {@code onX}. */
    public static String getCallbackTopicName(String topicMethod) {
        if (topicMethod.startsWith(PUBLISH)) {
            return "on" + capitalize(topicMethod.substring(PUBLISH.length()));
        }
        if (topicMethod.startsWith(GET)) {
            return "on" + capitalize(topicMethod.substring(GET.length()));
        }
        return "on" + capitalize(topicMethod);
    }

    public static String capitalize(String text) {
        return text == null || text.isEmpty() ? text : Character.toUpperCase(text.charAt(0)) + text.substring(1);
    }

    /** Returns the class name of a service type. */
    public static String makeFullTypeName(String type) {
        return type == null || type.indexOf('.') >= 0 ? type : SERVICES + type;
    }

    /** Returns the type without its package. */
    public static String getSimpleName(String type) {
        return type.substring(type.lastIndexOf('.') + 1);
    }

    /** Returns the name as a legal Python variable name. */
    public static String getSafeReferenceName(String name) {
        return name.replaceAll("[^A-Za-z0-9_]", "_");
    }

    /** Returns the types of the arguments, for messages. */
    public static String getParameterSignature(Object[] data) {
        if (data == null) {
            return "";
        }
        StringBuilder types = new StringBuilder();
        for (Object one : data) {
            types.append(types.length() == 0 ? "" : ", ").append(one == null ? "null" : one.getClass().getSimpleName());
        }
        return types.toString();
    }

    public static String toJson(Object object) {
        return Json.write(object);
    }

    public static <T> T fromJson(String json, Class<T> type) {
        return Json.read(json, type);
    }

    public static Object fromJson(String json) {
        return Json.read(json, Object.class);
    }

    public static String toYaml(Object object) {
        return Yaml.write(object);
    }

    public static <T> T fromYaml(String yaml, Class<T> type) {
        return Yaml.read(yaml, type);
    }
}
