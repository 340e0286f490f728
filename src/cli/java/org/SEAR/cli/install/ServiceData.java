// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.nio.charset.StandardCharsets;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BiConsumer;

/**
 * Entries in MyRobotLab's {@code libraries/serviceData.json}, the list of its service picker. A new entry copies the
 * fields of Clock's entry, so it suits every version of MyRobotLab. Pure functions.
 */
final class ServiceData {
    /** Descriptions in the service picker, by simple name. */
    static final Map<String, String> SERVICES = new TreeMap<>(Map.of(
        "SEAR", "Robot simulator: worlds and robots from scripts, with the sensors and serial protocols of "
        + "real hardware", "LIDAR", "SICK LMS200 laser scanner, real or simulated",
        "GPS", "GPS receiver that sends NMEA 0183, real or simulated"));
    private static final String PACKAGE = "org.myrobotlab.service.";
    private static final ObjectMapper MAPPER = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);

    private ServiceData() {
    }

    /** Adds SEAR's services to the file, each in its category; returns the same bytes if all are there. */
    static byte[] with(byte[] text) throws InstallException {
        return edited(text, ServiceData::add);
    }

    /** Removes SEAR's services from the file; returns the same bytes if there are none. */
    static byte[] without(byte[] text) throws InstallException {
        return edited(text, ServiceData::remove);
    }

    private static byte[] edited(byte[] text, BiConsumer<ObjectNode, String> edit) throws InstallException {
        try {
            JsonNode read = MAPPER.readTree(new String(text, StandardCharsets.UTF_8));
            if (!(read.path("serviceTypes") instanceof ObjectNode)) {
                throw new InstallException("libraries/serviceData.json has no serviceTypes. Delete it; MyRobotLab "
                    + "recreates it at its next start.");
            }
            ObjectNode root = read.deepCopy();
            SERVICES.keySet().forEach(service -> edit.accept(root, service));
            return root.equals(read) ? text : (MAPPER.writeValueAsString(root) + "\n").getBytes(StandardCharsets.UTF_8);
        } catch (JsonProcessingException e) {
            throw new InstallException("libraries/serviceData.json is not JSON (" + e.getOriginalMessage()
                + "). Delete it; MyRobotLab recreates it at its next start.");
        }
    }

    private static void add(ObjectNode root, String service) {
        ObjectNode types = (ObjectNode) root.get("serviceTypes");
        ObjectNode entry = MAPPER.createObjectNode();
        types.path(PACKAGE + "Clock").fields().forEachRemaining(field -> entry.set(field.getKey(),
            !field.getValue().isTextual() || "class".equals(field.getKey()) ? field.getValue()
                : new TextNode(field.getValue().asText().replace("Clock", service))));
        entry.put("available", true).put("description", SERVICES.get(service)).put("simpleName", service)
            .put("type", PACKAGE + service);
        entry.putArray("dependencies");
        entry.put("license", "apache").remove("link");
        types.set(PACKAGE + service, entry);
        JsonNode category = root.path("categoryTypes").path("SEAR".equals(service) ? "simulator" : "sensors")
            .path("serviceTypes");
        if (category instanceof ArrayNode && !MAPPER.convertValue(category, List.class).contains(PACKAGE + service)) {
            ((ArrayNode) category).add(PACKAGE + service);
        }
    }

    private static void remove(ObjectNode root, String service) {
        ((ObjectNode) root.get("serviceTypes")).remove(PACKAGE + service);
        for (JsonNode category : root.path("categoryTypes")) {
            for (Iterator<JsonNode> types = category.path("serviceTypes").elements(); types.hasNext();) {
                if (types.next().asText().equals(PACKAGE + service)) {
                    types.remove();
                }
            }
        }
    }
}
