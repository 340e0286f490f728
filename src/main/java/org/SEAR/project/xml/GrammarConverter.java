// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.xml;

import com.thoughtworks.xstream.converters.Converter;
import com.thoughtworks.xstream.converters.MarshallingContext;
import com.thoughtworks.xstream.converters.UnmarshallingContext;
import com.thoughtworks.xstream.io.HierarchicalStreamReader;
import com.thoughtworks.xstream.io.HierarchicalStreamWriter;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;

/** Converts objects to XML elements and back by their {@link ParameterTable}. Immutable, any thread. */
final class GrammarConverter implements Converter {
    @Override
    public boolean canConvert(@SuppressWarnings("rawtypes") Class type) {
        return type != null && !ParameterTable.of(type).getParameters().isEmpty();
    }

    @Override
    public void marshal(Object source, HierarchicalStreamWriter writer, MarshallingContext context) {
        for (Parameter parameter : ParameterTable.of(source.getClass()).getParameters()) {
            for (Object value : parameter.values(source)) {
                writer.startNode(parameter.getName());
                if (parameter.getKind() == Parameter.Kind.GROUP) {
                    marshal(value, writer, context);
                } else {
                    writer.setValue(Parameter.format(value));
                }
                writer.endNode();
            }
        }
    }

    @Override
    public Object unmarshal(HierarchicalStreamReader reader, UnmarshallingContext context) {
        return ((ObjectReader) context.get(ObjectReader.class)).read(reader, context.getRequiredType());
    }
}
