/**
 * What is made of pictures: what a sensor's electrons make of light, pieces of a colour, files. Uses {@link org.SEAR.POJOs}, and what that uses.
 * Any thread.
 */
package org.SEAR.camera.image;
