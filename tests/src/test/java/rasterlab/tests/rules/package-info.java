/**
 * The rules that keep the architecture: who may depend on whom, how large a file or function may
 * be, what must not stand in the sources.
 */
package rasterlab.tests.rules;
