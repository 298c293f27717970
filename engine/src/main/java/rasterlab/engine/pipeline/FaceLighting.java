package rasterlab.engine.pipeline;

import rasterlab.engine.light.FaceSide;
import rasterlab.engine.light.Shading;
import rasterlab.engine.light.ToneShading;
import rasterlab.engine.visibility.FlatPaint;
import rasterlab.engine.visibility.ViewedMesh;

/** The light stage: a colour for each face, the same for every visibility method. */
final class FaceLighting {
    private FaceLighting() {}

    static FlatPaint paint(ViewedMesh view, int[] faceRgb, Shading shading, boolean outline) {
        int[] fill = new int[faceRgb.length];
        int[] edges = new int[outline ? faceRgb.length : 0];
        for (int f = 0; f < faceRgb.length; f++) {
            double intensity = shading.intensity(side(view, f));
            fill[f] = Shading.shade(faceRgb[f], intensity);
            if (outline) edges[f] = Shading.shade(faceRgb[f], ToneShading.OUTLINE * intensity);
        }
        return new FlatPaint(fill, edges);
    }

    static FaceSide side(ViewedMesh view, int face) {
        boolean inner = view.seenFromInside(face);
        double sign = inner ? -1 : 1;
        double[] toEye = toEye(view, face);
        return new FaceSide(
                sign * view.eyeNormal(face, 0),
                sign * view.eyeNormal(face, 1),
                sign * view.eyeNormal(face, 2),
                toEye[0],
                toEye[1],
                toEye[2],
                inner);
    }

    /** From the mean of the corners to the eye; straight back in parallel projection. */
    private static double[] toEye(ViewedMesh view, int face) {
        if (!view.transform().central()) return new double[] {0, 0, -1};
        double x = 0;
        double y = 0;
        double z = 0;
        int corners = view.mesh().cornerCount(face);
        for (int k = 0; k < corners; k++) {
            int vertex = view.mesh().corner(face, k);
            x -= view.eyeX(vertex);
            y -= view.eyeY(vertex);
            z -= view.eyeZ(vertex);
        }
        double length = Math.sqrt(x * x + y * y + z * z);
        if (length == 0) return new double[] {0, 0, -1};
        return new double[] {x / length, y / length, z / length};
    }
}
