// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import org.SEAR.project.Project;
import picocli.CommandLine.IVersionProvider;

/** The version of SEAR from its jar. */
final class Version implements IVersionProvider {
    @Override
    public String[] getVersion() {
        String version = Project.class.getPackage().getImplementationVersion();
        return new String[] {"SEAR " + (version == null ? "(development)" : version)};
    }
}
