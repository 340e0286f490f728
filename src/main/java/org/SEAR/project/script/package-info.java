// SPDX-License-Identifier: Apache-2.0
/**
 * Python scripts that reproduce a project, generated from the parameters of the grammar. Uses {@link org.SEAR.project}
 * and its dependencies. Reads projects; no threads of its own.
 */
package org.SEAR.project.script;
