package rasterlab.engine.scene;

/** The surfaces that a scene's faces stand for. */
public interface ExactSurfaces {
    /** One for each thread. */
    Caster caster();

    /** Casts rays, one at a time, and tells of the place that the last one met. */
    interface Caster {
        /**
         * @param ray origin x, y, z and direction x, y, z, in the world
         * @param least places count whose t is above this, in lengths of the direction
         * @return the number of the finish that the nearest place has, or −1 if there is none
         */
        int meet(double[] ray, double least);

        /** How far along the ray. */
        double distance();

        /** World x; axis 1 is y, 2 is z. */
        double place(int axis);

        /** A coordinate of the outward normal, of length 1. */
        double normal(int axis);

        double textureS();

        double textureT();

        /** Whether the ray came from the side the normal does not point to. */
        boolean fromInside();
    }
}
