// SPDX-License-Identifier: Apache-2.0
/** Draws SEAR's bundled textures, icons and tree during the build. Independent of the rest of SEAR. Main thread. */
package org.SEAR.assets;
