/**
 * The types every topic shares: a topic is a contract, a method implements it, a study gives each
 * method a cost and an error, a hazard is an input on which methods fail, a mutant is a likely
 * mistake by name.
 *
 * <p>A topic's mutants stand beside its hazards, in one class {@code …Mutants}: the topic hands
 * them out and they change its right methods, so a package of their own would form a circle with
 * the topic's. Start with {@link rasterlab.engine.study.Topic}.
 */
package rasterlab.engine.study;
