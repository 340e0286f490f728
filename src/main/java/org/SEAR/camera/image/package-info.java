// SPDX-License-Identifier: Apache-2.0
/**
 * Processing of pictures: sensor exposure and noise, regions of a colour, file formats. Uses {@link org.SEAR.POJOs} and
 * its dependencies. Any thread.
 */
package org.SEAR.camera.image;
