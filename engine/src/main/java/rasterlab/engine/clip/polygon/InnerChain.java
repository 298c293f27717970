package rasterlab.engine.clip.polygon;

/**
 * A longest part of the subject's boundary that runs strictly inside the window.
 *
 * @param enter where it begins on the rim
 * @param leave where it ends on the rim
 * @param corners x and y of the subject's corners between, in turn
 * @param touchesHollow whether it ends at a corner of the subject that touches the rim from inside
 *     and turns right there, so that the subject fills the rim on both sides of it
 */
record InnerChain(RimPoint enter, RimPoint leave, double[] corners, boolean touchesHollow) {}
