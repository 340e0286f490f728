/**
 * Models of a project, loaded without trust. Uses {@link org.SEAR.POJOs}, {@link org.SEAR.files} and {@link org.SEAR.geometry}, and what these use.
 * A loader serves one thread at a time.
 */
package org.SEAR.project.models;
