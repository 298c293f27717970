package rasterlab.contract;

/** Computes points of a curve: those at given t, or so many that a polyline looks like it. */
public interface CurveTracer extends CurveEvaluator, CurveFlattener {}
