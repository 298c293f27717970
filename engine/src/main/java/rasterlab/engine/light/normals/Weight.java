package rasterlab.engine.light.normals;

/** How much say a face has in the normal of one of its corners. */
enum Weight {
    /** Every face the same. */
    PLAIN("1 for every face") {
        @Override
        double of(double area, double angle) {
            return 1;
        }
    },
    /** The face's area. */
    AREA("area of the face over the largest") {
        @Override
        double of(double area, double angle) {
            return area;
        }
    },
    /** The face's angle at the corner. */
    ANGLE("angle of the face at the vertex, in radians") {
        @Override
        double of(double area, double angle) {
            return angle;
        }
    };

    private final String formula;

    Weight(String formula) {
        this.formula = formula;
    }

    String formula() {
        return formula;
    }

    /**
     * @param area of the face, times any factor
     * @param angle of the face at the corner, in radians
     */
    abstract double of(double area, double angle);
}
