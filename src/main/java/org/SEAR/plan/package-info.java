/**
 * The plan of a world: what it looks like from above, as outlines and as a picture. Uses {@link org.SEAR.POJOs}, {@link org.SEAR.geometry},
 * {@link org.SEAR.plot}, {@link org.SEAR.project}, {@link org.SEAR.robot}, {@link org.SEAR.scene}, {@link org.SEAR.sensors} and
 * {@link org.SEAR.simulator}. No threads of its own.
 */
package org.SEAR.plan;
