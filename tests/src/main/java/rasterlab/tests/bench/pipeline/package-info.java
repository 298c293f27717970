/**
 * The fast pipeline beside OpenGL's software renderer, Java2D and the memory's limit, in turn in
 * one process. Start with {@link rasterlab.tests.bench.pipeline.PipelineBench}.
 */
package rasterlab.tests.bench.pipeline;
