// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.xml;

import com.thoughtworks.xstream.io.HierarchicalStreamReader;
import com.thoughtworks.xstream.io.ReaderWrapper;
import org.SEAR.project.problems.ProblemList;

/**
 * Hides all attributes from XStream, so that none can name a class or a reference, and reports those of the root
 * element.
 */
final class RootWithoutAttributes extends ReaderWrapper {

    RootWithoutAttributes(HierarchicalStreamReader reader, String file, int line, ProblemList problems) {
        super(reader);
        ObjectReader.reportAttributes(reader, file, line, problems);
    }

    @Override
    public String getAttribute(String name) {
        return null;
    }
}
