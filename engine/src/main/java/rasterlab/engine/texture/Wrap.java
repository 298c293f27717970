package rasterlab.engine.texture;

/** The rule that continues a texture outside of 0 to 1, along s or t. */
public enum Wrap {
    /** The picture again and again. */
    REPEAT {
        @Override
        double within(double s) {
            double rest = s - Math.floor(s);
            return rest < 1 ? rest : 0;
        }

        @Override
        int index(int i, int size) {
            return i < 0 ? i + size : i >= size ? i - size : i;
        }
    },
    /** The picture and its mirror image in turn. */
    MIRRORED {
        @Override
        double within(double s) {
            double rest = s - 2 * Math.floor(s / 2);
            return rest > 1 ? 2 - rest : rest;
        }

        @Override
        int index(int i, int size) {
            return Math.max(0, Math.min(size - 1, i));
        }
    },
    /** The outermost texels go on for ever. */
    CLAMP_TO_EDGE {
        @Override
        double within(double s) {
            return Math.max(0, Math.min(1, s));
        }

        @Override
        int index(int i, int size) {
            return Math.max(0, Math.min(size - 1, i));
        }
    },
    /**
     * s is cut to 0 to 1; what lies beyond the outermost texels' centres is mixed with a border
     * that is transparent black, as in OpenGL 1.
     */
    CLAMP {
        @Override
        double within(double s) {
            return Math.max(0, Math.min(1, s));
        }

        @Override
        int index(int i, int size) {
            return i < 0 || i >= size ? BORDER : i;
        }
    };

    /** The index of what is no texel but the border. */
    static final int BORDER = -1;

    /** The place of the picture, 0 to 1, that stands at s. */
    abstract double within(double s);

    /** The texel for an index up to one beyond the ends, or {@link #BORDER}. */
    abstract int index(int i, int size);
}
