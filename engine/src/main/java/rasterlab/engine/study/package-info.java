/**
 * The types every topic shares: a topic is a contract, a method implements it, a study gives each
 * method a cost and an error, a hazard is an input on which methods fail.
 *
 * <p>Start with {@link rasterlab.engine.study.Topic}.
 */
package rasterlab.engine.study;
