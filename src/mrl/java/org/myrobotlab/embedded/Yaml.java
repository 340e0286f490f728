// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import org.myrobotlab.service.config.ServiceConfig;
import org.yaml.snakeyaml.DumperOptions;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.constructor.Constructor;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.introspector.BeanAccess;
import org.yaml.snakeyaml.representer.Representer;

/** Configurations as YAML. Any thread. */
public final class Yaml {
    private Yaml() {
    }

    public static String write(Object config) {
        DumperOptions options = new DumperOptions();
        options.setDefaultFlowStyle(DumperOptions.FlowStyle.BLOCK);
        return new org.yaml.snakeyaml.Yaml(new Representer(options), options).dump(config);
    }

    /** @throws IllegalArgumentException if the text is not YAML of this configuration type */
    public static <T> T read(String text, Class<T> type) {
        LoaderOptions options = new LoaderOptions();
        String allowed = ServiceConfig.class.getPackageName() + ".";
        options.setTagInspector(tag -> tag.getClassName().startsWith(allowed));
        org.yaml.snakeyaml.Yaml yaml = new org.yaml.snakeyaml.Yaml(new Constructor(options));
        yaml.setBeanAccess(BeanAccess.FIELD);
        try {
            return type.cast(yaml.load(text));
        } catch (YAMLException | ClassCastException e) {
            throw new IllegalArgumentException("not a configuration " + type.getSimpleName() + ": "
                + e.getMessage(), e);
        }
    }
}
