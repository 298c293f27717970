package rasterlab.engine.visibility;

import rasterlab.engine.transform.PictureFit;

/**
 * Nearness over one face, ρ/z in perspective and −z in parallel projection, as a linear function of
 * the pixel: {@code base + x·perColumn + y·perRow}. z itself is not linear in perspective.
 *
 * <p>It is that of the {@link PixelPoint}: of two faces that meet in a line through centres the one
 * that is nearer beside it is the nearer.
 */
public final class NearnessPlane {
    public double base;
    public double perColumn;
    public double perRow;
    private double most;

    /**
     * Loads the plane n·p = k, which becomes ρ/z = (nx·X + ny·Y + nz·ρ)/k in perspective and −z =
     * (nx·X + ny·Y − k)/nz in parallel projection, with X, Y on the picture plane.
     *
     * @return false for a face seen exactly edge-on: it covers nothing
     */
    public boolean load(ViewedMesh view, int face) {
        double nx = view.eyeNormal(face, 0);
        double ny = view.eyeNormal(face, 1);
        double nz = view.eyeNormal(face, 2);
        double k = view.planeOffset(face);
        boolean central = view.transform().central();
        double divisor = central ? k : nz;
        if (divisor == 0) return false;
        double perUnitX = nx / divisor;
        double perUnitY = ny / divisor;
        double middle = central ? nz * view.transform().distance() / k : -k / nz;
        PictureFit fit = view.fit();
        perColumn = perUnitX / fit.pixelsPerUnit();
        perRow = -perUnitY / fit.pixelsPerUnit();
        base =
                middle
                        + perUnitX * fit.toPlaneX(PixelPoint.RIGHT_OF_CENTER)
                        + perUnitY * fit.toPlaneY(PixelPoint.BELOW_CENTER);
        double inPicture =
                Math.abs(base)
                        + Math.abs(perColumn) * fit.width()
                        + Math.abs(perRow) * fit.height();
        // k is a sum of products as large as the corner, which may cancel.
        double corner = mostOf(view, view.mesh().corner(face, 0));
        most =
                central
                        ? inPicture * Math.max(1, corner / Math.abs(k))
                        : inPicture + corner / Math.abs(nz);
        return true;
    }

    private static double mostOf(ViewedMesh view, int vertex) {
        return Math.abs(view.eyeX(vertex))
                + Math.abs(view.eyeY(vertex))
                + Math.abs(view.eyeZ(vertex));
    }

    /**
     * The most that nearness can be in the picture, and what its parts can be before they cancel.
     */
    public double most() {
        return most;
    }
}
