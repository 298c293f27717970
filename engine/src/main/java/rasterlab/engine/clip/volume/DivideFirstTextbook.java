package rasterlab.engine.clip.volume;

import rasterlab.contract.SpaceSegmentSink;

/**
 * Division before clipping, kept to be looked at beside {@link HomogeneousClip}.
 *
 * <p>Both ends are put through M_p and divided by W = z: X = x/z, Y = y/z, Z = (z − zmin)/((1 −
 * zmin)·z). Then the segment between the two is cut by the box −1..1, −1..1, 0..1, and its ends are
 * taken back by z = zmin/(1 − (1 − zmin)·Z), x = X·z, y = Y·z. That is right while both ends are in
 * front of the eye. From one behind it (z &lt; 0) the picture of the segment runs through infinity,
 * but between the divided ends a straight segment is cut, which is the picture of all that does not
 * lie between the ends. At the eye (z = 0) there is nothing to divide by: infinities and NaN come
 * out.
 *
 * <p>Source: what the order "clip, then divide" of J. F. Blinn, M. E. Newell, Clipping using
 * homogeneous coordinates, SIGGRAPH 1978, pp. 245–251, is there to avoid.
 */
public final class DivideFirstTextbook implements SteppedVolumeClipper {
    private static final String[] PLANES = {"X = 1", "X = -1", "Y = 1", "Y = -1", "Z = 0", "Z = 1"};

    @Override
    public VolumeWalk walk(
            double zmin, double x0, double y0, double z0, double x1, double y1, double z1) {
        return new Walk(zmin, new double[] {x0, y0, z0}, new double[] {x1, y1, z1});
    }

    @Override
    public String decisionFormula() {
        return "t = b0/(b0 − b1), b = 1 − X, 1 + X, 1 − Y, 1 + Y, Z, 1 − Z";
    }

    private static final class Walk implements VolumeWalk {
        private final double zmin;
        private final double[] ndcFrom;
        private final double[] ndcTo;
        private double enter;
        private double leave = 1;
        private double t = Double.NaN;
        private int divisions;
        private int plane = -1;

        Walk(double zmin, double[] eyeFrom, double[] eyeTo) {
            this.zmin = zmin;
            ndcFrom = divided(eyeFrom[0], eyeFrom[1], eyeFrom[2]);
            ndcTo = divided(eyeTo[0], eyeTo[1], eyeTo[2]);
        }

        private double[] divided(double eyeX, double eyeY, double eyeZ) {
            divisions += 3;
            return new double[] {eyeX / eyeZ, eyeY / eyeZ, (eyeZ - zmin) / ((1 - zmin) * eyeZ)};
        }

        @Override
        public boolean advance() {
            if (plane == 5 || enter > leave) return false;
            plane++;
            cut(border(ndcFrom), border(ndcTo));
            return true;
        }

        /** The distance from the box's side, above 0 within. */
        private double border(double[] ndc) {
            double coordinate = ndc[plane / 2];
            if (plane == 4) return coordinate;
            return plane % 2 == 0 || plane == 5 ? 1 - coordinate : 1 + coordinate;
        }

        private void cut(double b0, double b1) {
            t = Double.NaN;
            if (b0 < 0 && b1 < 0) leave = Double.NEGATIVE_INFINITY;
            if (b0 < 0 == b1 < 0) return;
            t = b0 / (b0 - b1);
            divisions++;
            if (b0 < 0) enter = Math.max(enter, t);
            else leave = Math.min(leave, t);
        }

        @Override
        public void send(SpaceSegmentSink out) {
            if (!(enter <= leave)) return;
            divisions += 2;
            piece(out);
        }

        @Override
        public void piece(SpaceSegmentSink out) {
            double[] from = eye(enter);
            double[] to = eye(leave);
            out.segment(from[0], from[1], from[2], to[0], to[1], to[2]);
        }

        private double[] eye(double at) {
            var ndc = new double[3];
            for (int i = 0; i < 3; i++) ndc[i] = ndcFrom[i] + at * (ndcTo[i] - ndcFrom[i]);
            double eyeZ = zmin / (1 - (1 - zmin) * ndc[2]);
            return new double[] {ndc[0] * eyeZ, ndc[1] * eyeZ, eyeZ};
        }

        @Override
        public String at() {
            return plane < 0 ? "" : PLANES[plane];
        }

        @Override
        public double decision() {
            return t;
        }

        @Override
        public int divisions() {
            return divisions;
        }

        @Override
        public boolean unsure() {
            return false;
        }
    }
}
