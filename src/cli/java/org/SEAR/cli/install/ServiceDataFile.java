package org.SEAR.cli.install;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Iterator;

/**
 * MyRobotLab's {@code libraries/serviceData.json}: what its service picker offers. An entry has the shape of Clock's, so whatever fields this MRL's
 * version knows, ours have them too. Any one thread.
 */
final class ServiceDataFile {
    private static final String PACKAGE = "org.myrobotlab.service.";
    private static final String MODEL = PACKAGE + "Clock";
    private final ObjectMapper mapper = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);
    private final ObjectNode root;

    /** @throws InstallException if the text is not MyRobotLab's service data */
    ServiceDataFile(String text) throws InstallException {
        try {
            JsonNode read = mapper.readTree(text);
            if (!(read instanceof ObjectNode) || !(read.get("serviceTypes") instanceof ObjectNode)) {
                throw new InstallException("libraries/serviceData.json has no serviceTypes. Delete it; MyRobotLab makes it anew at its next start.");
            }
            root = (ObjectNode) read;
        } catch (JsonProcessingException e) {
            throw new InstallException("libraries/serviceData.json is not JSON (" + e.getOriginalMessage()
                + "). Delete it; MyRobotLab makes it anew at its next start.", e);
        }
    }

    /**
     * Adds or renews a service's entry, and its place in each category.
     *
     * @return whether anything changed
     */
    boolean add(String simpleName, String description, String... categories) {
        ObjectNode before = root.deepCopy();
        ObjectNode types = (ObjectNode) root.get("serviceTypes");
        ObjectNode entry = types.get(MODEL) instanceof ObjectNode ? ((ObjectNode) types.get(MODEL)).deepCopy() : mapper.createObjectNode();
        Iterator<String> fields = entry.deepCopy().fieldNames();
        while (fields.hasNext()) {
            String field = fields.next();
            if (entry.get(field).isTextual() && !"class".equals(field)) {
                entry.put(field, entry.get(field).asText().replace("Clock", simpleName));
            }
        }
        entry.put("available", true);
        entry.put("description", description);
        entry.put("simpleName", simpleName);
        entry.put("type", PACKAGE + simpleName);
        entry.set("dependencies", mapper.createArrayNode());
        entry.put("license", "apache");
        entry.remove("link");
        types.set(PACKAGE + simpleName, entry);
        for (String category : categories) {
            addTo(category, PACKAGE + simpleName);
        }
        return !before.equals(root);
    }

    private void addTo(String category, String type) {
        JsonNode known = root.path("categoryTypes").path(category).path("serviceTypes");
        if (known instanceof ArrayNode && !contains((ArrayNode) known, type)) {
            ((ArrayNode) known).add(type);
        }
    }

    private static boolean contains(ArrayNode list, String text) {
        for (JsonNode item : list) {
            if (item.asText().equals(text)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Takes a service out of the picker again.
     *
     * @return whether it was there
     */
    boolean remove(String simpleName) {
        String type = PACKAGE + simpleName;
        boolean there = ((ObjectNode) root.get("serviceTypes")).remove(type) != null;
        for (JsonNode category : root.path("categoryTypes")) {
            JsonNode list = category.path("serviceTypes");
            for (int i = list.size() - 1; i >= 0; i--) {
                if (list.get(i).asText().equals(type)) {
                    ((ArrayNode) list).remove(i);
                    there = true;
                }
            }
        }
        return there;
    }

    /** The file's text. */
    String text() throws InstallException {
        try {
            return mapper.writeValueAsString(root) + "\n";
        } catch (JsonProcessingException e) {
            throw new InstallException("Cannot write service data: " + e.getOriginalMessage(), e);
        }
    }
}
