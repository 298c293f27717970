package rasterlab.engine.visibility.scan;

import java.util.Arrays;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.NearnessPlane;
import rasterlab.engine.visibility.OnePlane;
import rasterlab.engine.visibility.RowSpan;
import rasterlab.engine.visibility.ScreenPolygon;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * All faces that own pixels, projected once: corners in pixels, the box of pixels and the nearness
 * of each. Faces keep the order of the mesh and are named by their place here.
 */
final class ScreenFaces {
    private final ViewedMesh view;
    private final int[] face;
    private final int[] firstCorner;
    private double[] x;
    private double[] y;
    private final int[] box;
    private final double[] nearness;
    private final double[] room;
    private final boolean[] opaque;
    private int count;
    private int corners;

    ScreenFaces(ViewedMesh view, FacePaint paint) {
        this.view = view;
        int faces = view.mesh().faceCount();
        face = new int[faces];
        firstCorner = new int[faces + 1];
        box = new int[4 * faces];
        nearness = new double[3 * faces];
        room = new double[faces];
        opaque = new boolean[faces];
        x = new double[4 * faces + 8];
        y = new double[4 * faces + 8];
        var polygon = new ScreenPolygon(view);
        var plane = new NearnessPlane();
        for (int f = 0; f < faces; f++) {
            if (!plane.load(view, f)) continue;
            polygon.load(view, f);
            if (!boxed(polygon)) continue;
            opaque[count] = paint.opaque(f);
            add(f, polygon, plane);
        }
    }

    /** Puts the box of pixels in the next place; false where it holds no pixel of the picture. */
    private boolean boxed(ScreenPolygon polygon) {
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double top = Double.POSITIVE_INFINITY;
        double bottom = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < polygon.size(); k++) {
            left = Math.min(left, polygon.x(k));
            right = Math.max(right, polygon.x(k));
            top = Math.min(top, polygon.y(k));
            bottom = Math.max(bottom, polygon.y(k));
        }
        int at = 4 * count;
        box[at] = (int) Math.max(0, Math.ceil(left));
        box[at + 1] = (int) Math.min(view.fit().width(), Math.ceil(right));
        box[at + 2] = (int) Math.max(0, Math.ceil(top));
        box[at + 3] = (int) Math.min(view.fit().height(), Math.ceil(bottom));
        return box[at] < box[at + 1] && box[at + 2] < box[at + 3];
    }

    private void add(int number, ScreenPolygon polygon, NearnessPlane plane) {
        if (corners + polygon.size() > x.length) {
            x = Arrays.copyOf(x, 2 * x.length + polygon.size());
            y = Arrays.copyOf(y, x.length);
        }
        for (int k = 0; k < polygon.size(); k++, corners++) {
            x[corners] = polygon.x(k);
            y[corners] = polygon.y(k);
        }
        nearness[3 * count] = plane.base;
        nearness[3 * count + 1] = plane.perColumn;
        nearness[3 * count + 2] = plane.perRow;
        room[count] = OnePlane.room(plane.most());
        face[count++] = number;
        firstCorner[count] = corners;
    }

    int count() {
        return count;
    }

    /** The number in the mesh. */
    int face(int place) {
        return face[place];
    }

    boolean opaque(int place) {
        return opaque[place];
    }

    int firstCorner(int place) {
        return firstCorner[place];
    }

    double x(int corner) {
        return x[corner];
    }

    double y(int corner) {
        return y[corner];
    }

    /** The first column that may hold a pixel of the face. */
    int left(int place) {
        return box[4 * place];
    }

    /** The column after the last that may. */
    int right(int place) {
        return box[4 * place + 1];
    }

    /** The first row that may. */
    int top(int place) {
        return box[4 * place + 2];
    }

    /** The row after the last that may. */
    int bottom(int place) {
        return box[4 * place + 3];
    }

    /** Nearness of the face's plane at a pixel: the larger, the nearer. */
    double nearness(int place, int pixelX, int pixelY) {
        int at = 3 * place;
        return nearness[at] + pixelY * nearness[at + 2] + pixelX * nearness[at + 1];
    }

    /** Whether one is nearer than another at a pixel; in {@link OnePlane} the earlier face is. */
    boolean nearer(int one, int other, int pixelX, int pixelY) {
        double here = nearness(one, pixelX, pixelY);
        double there = nearness(other, pixelX, pixelY);
        if (here == there) return one < other;
        if (Math.abs(here - there) <= room[one] && onePlane(one, other)) return one < other;
        return here > there;
    }

    /** Whether nearnesses differ no more than rounding makes them, anywhere in the picture. */
    private boolean onePlane(int one, int other) {
        int a = 3 * one;
        int b = 3 * other;
        double apart =
                Math.abs(nearness[a] - nearness[b])
                        + Math.abs(nearness[a + 1] - nearness[b + 1]) * view.fit().width()
                        + Math.abs(nearness[a + 2] - nearness[b + 2]) * view.fit().height();
        return apart <= room[one];
    }

    /** Takes the pixels of one row that the face owns. */
    void load(int place, int row, RowSpan span) {
        span.load(x, y, firstCorner[place], firstCorner[place + 1], row);
    }
}
