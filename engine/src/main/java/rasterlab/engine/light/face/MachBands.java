package rasterlab.engine.light.face;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.LitFace;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Method;

/**
 * Brightness along the equator of a shiny faceted sphere, from its western to its eastern rim as
 * the eye sees it; the lamp stands aside.
 *
 * <p>Source of the name: E. Mach, 1865, who found that the eye sees bright and dark bands where
 * brightness or its slope jumps.
 */
public final class MachBands {
    /** Faces across the half that is seen. */
    public static final int FACETS = 8;

    /** The shadings that are compared, the coarsest first. */
    public static final List<String> SHADINGS = List.of("flat", "gouraud", "phong");

    private static final double[] LAMP = {3, 0, 6};
    private static final double[] EYE = {0, 0, 8};
    private static final SurfaceMaterial SHINY = FaceSamples.gray(0.6, 0.35, 30);

    private MachBands() {}

    /**
     * @param shading one of {@link #SHADINGS}
     * @param perFace samples of each face, at least 3
     */
    public static BrightnessProfile profile(String shading, int perFace) {
        return BrightnessProfile.along(
                Named.find("shading", shading, FaceMethods.all(), Method::name).implementation(),
                belt(),
                perFace);
    }

    /** Triangles whose first edges make up the equator. */
    private static List<LitFace> belt() {
        List<LitFace> faces = new ArrayList<>();
        double width = Math.PI / FACETS;
        for (int i = 0; i < FACETS; i++) {
            double west = i * width - Math.PI / 2;
            var corners = new double[9];
            place(west, 0, corners, 0);
            place(west + width, 0, corners, 3);
            place(west + width / 2, width, corners, 6);
            faces.add(FaceSamples.face(corners, corners, LAMP, EYE, SHINY));
        }
        return faces;
    }

    private static void place(double longitude, double latitude, double[] corners, int at) {
        corners[at] = Math.sin(longitude) * Math.cos(latitude);
        corners[at + 1] = Math.sin(latitude);
        corners[at + 2] = Math.cos(longitude) * Math.cos(latitude);
    }
}
