package rasterlab.engine.light.normals;

/** How much say a face has in the normal of one of its corners. */
enum Weight {
    /** Every face the same. */
    PLAIN {
        @Override
        double of(double area, double angle) {
            return 1;
        }
    },
    /** The face's area. */
    AREA {
        @Override
        double of(double area, double angle) {
            return area;
        }
    },
    /** The face's angle at the corner. */
    ANGLE {
        @Override
        double of(double area, double angle) {
            return angle;
        }
    };

    /**
     * @param area of the face, times any factor
     * @param angle of the face at the corner, in radians
     */
    abstract double of(double area, double angle);
}
