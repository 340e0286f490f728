// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.meta.abstracts;

import java.io.Serializable;
import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import org.myrobotlab.framework.Plan;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.service.config.ServiceConfig;
import org.slf4j.Logger;

/** Description of a service type. Each type X has a class XMeta. */
public class MetaData implements Serializable {
    public static final Logger log = LoggerFactory.getLogger(MetaData.class);

    private static final long serialVersionUID = 1L;
    private static final String PACKAGE = "org.myrobotlab.service.meta.";
    private static final String SERVICES = "org.myrobotlab.service.";

    public boolean installed = true;
    public transient Set<String> categories = new TreeSet<>();
    private final String simpleName;
    private boolean available = true;
    private String description;
    private String license;
    private String link;

    public MetaData() {
        String name = getClass().getSimpleName();
        simpleName = name.endsWith("Meta") ? name.substring(0, name.length() - "Meta".length()) : name;
    }

    /**
     * Returns the data of a type, given with or without package.
     *
     * @throws IllegalArgumentException if there is none
     */
    public static MetaData get(String type) {
        String simple = type.substring(type.lastIndexOf('.') + 1);
        try {
            return (MetaData) Class.forName(PACKAGE + simple + "Meta").getConstructor().newInstance();
        } catch (ReflectiveOperationException e) {
            throw new IllegalArgumentException("service type " + simple + " has no meta data: class " + PACKAGE + simple
                + "Meta is missing", e);
        }
    }

    public void addDescription(String text) {
        description = text;
    }

    public void addCategory(String... names) {
        categories.addAll(Arrays.asList(names));
    }

    /** Names a library that the service needs. Ignored here: the embedded MyRobotLab has all its libraries. */
    public void addDependency(String orgId, String artifactId) {
        addDependency(orgId, artifactId, null);
    }

    public void addDependency(String orgId, String artifactId, String version) {
        addDependency(orgId, artifactId, version, null);
    }

    public void addDependency(String orgId, String artifactId, String version, String ext) {
        log.debug("{} needs {}:{}:{}:{}", simpleName, orgId, artifactId, version, ext);
    }

    public void addLicense(String text) {
        license = text;
    }

    public void setLicenseApache() {
        license = "Apache-2.0";
    }

    public void setLicenseGplV3() {
        license = "GPL-3.0";
    }

    public void setLicenseProprietary() {
        license = "proprietary";
    }

    public void setLink(String url) {
        link = url;
    }

    public void setAvailable(boolean on) {
        available = on;
    }

    public boolean isAvailable() {
        return available;
    }

    public String getDescription() {
        return description;
    }

    public String getLicense() {
        return license;
    }

    public String getLink() {
        return link;
    }

    /** Returns the type without its package. */
    public String getSimpleName() {
        return simpleName;
    }

    /** Returns the type with its package. */
    public String getType() {
        return SERVICES + simpleName;
    }

    /** Returns the default configurations of a service of this type and its peers. */
    public Plan getDefault(String name) {
        return ServiceConfig.getDefault(new Plan(name), name, simpleName);
    }

    @Override
    public String toString() {
        return simpleName;
    }
}
