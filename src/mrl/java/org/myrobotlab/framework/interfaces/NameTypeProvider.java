// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

/** Has a name and a type. */
public interface NameTypeProvider extends NameProvider, TypeProvider {
}
