package rasterlab.app.light;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.light.Substance;
import rasterlab.engine.transform.SphericalView;

/**
 * What the user chose, and what undo brings back.
 *
 * @param body what is lit
 * @param camera where it is seen from
 * @param zoom picture scale as a multiple of the scene's own, 0.25 to 8
 * @param material of the body
 * @param lamps at least one
 * @param selected the lamp whose settings are shown
 * @param ambient light from everywhere, 0 to 1
 * @param terms of the formula that are seen
 * @param reflection the specular term
 * @param localViewer whether each point has its own direction to the eye
 * @param twoSided whether backs are lit by themselves
 * @param arrows whether normals are drawn
 * @param mach whether the profile shows what the eye reports
 * @param line the profile's ends and the point, as shares of the picture
 */
record LightChoice(
        Body body,
        SphericalView camera,
        double zoom,
        MaterialChoice material,
        List<Lamp> lamps,
        int selected,
        double ambient,
        Set<LightTerm> terms,
        Reflection reflection,
        boolean localViewer,
        boolean twoSided,
        boolean arrows,
        boolean mach,
        Marks line) {
    static final int MOST_LAMPS = 6;

    /**
     * Places in the picture, each from 0 to 1, x to the right and y down.
     *
     * @param fromX of the profile's first end
     * @param toX of its other end
     * @param atX of the point
     */
    record Marks(double fromX, double fromY, double toX, double toY, double atX, double atY) {}

    LightChoice {
        lamps = List.copyOf(lamps);
        terms = Set.copyOf(terms);
    }

    /** A coarse brass sphere under a lamp and a dim second one. */
    static LightChoice first() {
        return new LightChoice(
                new Body("sphere", 12, Body.OWN),
                new SphericalView(Math.PI / 9, 1.2, 500),
                1.5,
                MaterialChoice.of(Substance.BRASS),
                List.of(
                        Lamp.at(112, -18, 103),
                        Lamp.at(35, 109, -16).withStrength(0.4).coloured(0x9EC9FF)),
                0,
                LightModel.AMBIENT,
                LightTerm.all(),
                Reflection.BLINN_PHONG,
                true,
                true,
                false,
                true,
                new Marks(0.1, 0.5, 0.9, 0.5, 0.4, 0.42));
    }

    LightChoice with(Body other) {
        return new LightChoice(
                other,
                camera,
                zoom,
                material,
                lamps,
                selected,
                ambient,
                terms,
                reflection,
                localViewer,
                twoSided,
                arrows,
                mach,
                line);
    }

    LightChoice with(SphericalView other) {
        return new LightChoice(
                body,
                other,
                zoom,
                material,
                lamps,
                selected,
                ambient,
                terms,
                reflection,
                localViewer,
                twoSided,
                arrows,
                mach,
                line);
    }

    LightChoice zoomed(double factor) {
        return new LightChoice(
                body,
                camera,
                Math.max(0.25, Math.min(8, zoom * factor)),
                material,
                lamps,
                selected,
                ambient,
                terms,
                reflection,
                localViewer,
                twoSided,
                arrows,
                mach,
                line);
    }

    LightChoice with(MaterialChoice other) {
        return new LightChoice(
                body,
                camera,
                zoom,
                other,
                lamps,
                selected,
                ambient,
                terms,
                reflection,
                localViewer,
                twoSided,
                arrows,
                mach,
                line);
    }

    LightChoice selecting(int lamp) {
        return new LightChoice(
                body,
                camera,
                zoom,
                material,
                lamps,
                lamp,
                ambient,
                terms,
                reflection,
                localViewer,
                twoSided,
                arrows,
                mach,
                line);
    }

    private LightChoice with(List<Lamp> other, int shown) {
        return new LightChoice(
                body,
                camera,
                zoom,
                material,
                other,
                shown,
                ambient,
                terms,
                reflection,
                localViewer,
                twoSided,
                arrows,
                mach,
                line);
    }

    LightChoice withAmbient(double share) {
        return new LightChoice(
                body,
                camera,
                zoom,
                material,
                lamps,
                selected,
                share,
                terms,
                reflection,
                localViewer,
                twoSided,
                arrows,
                mach,
                line);
    }

    LightChoice withTerms(Set<LightTerm> other) {
        return new LightChoice(
                body,
                camera,
                zoom,
                material,
                lamps,
                selected,
                ambient,
                other,
                reflection,
                localViewer,
                twoSided,
                arrows,
                mach,
                line);
    }

    LightChoice with(Reflection other) {
        return new LightChoice(
                body,
                camera,
                zoom,
                material,
                lamps,
                selected,
                ambient,
                terms,
                other,
                localViewer,
                twoSided,
                arrows,
                mach,
                line);
    }

    LightChoice withLocalViewer(boolean local) {
        return new LightChoice(
                body,
                camera,
                zoom,
                material,
                lamps,
                selected,
                ambient,
                terms,
                reflection,
                local,
                twoSided,
                arrows,
                mach,
                line);
    }

    LightChoice withTwoSides(boolean two) {
        return new LightChoice(
                body,
                camera,
                zoom,
                material,
                lamps,
                selected,
                ambient,
                terms,
                reflection,
                localViewer,
                two,
                arrows,
                mach,
                line);
    }

    LightChoice withArrows(boolean drawn) {
        return new LightChoice(
                body,
                camera,
                zoom,
                material,
                lamps,
                selected,
                ambient,
                terms,
                reflection,
                localViewer,
                twoSided,
                drawn,
                mach,
                line);
    }

    LightChoice withMach(boolean drawn) {
        return new LightChoice(
                body,
                camera,
                zoom,
                material,
                lamps,
                selected,
                ambient,
                terms,
                reflection,
                localViewer,
                twoSided,
                arrows,
                drawn,
                line);
    }

    LightChoice with(Marks other) {
        return new LightChoice(
                body,
                camera,
                zoom,
                material,
                lamps,
                selected,
                ambient,
                terms,
                reflection,
                localViewer,
                twoSided,
                arrows,
                mach,
                other);
    }

    /** The lamp whose settings are shown. */
    Lamp lamp() {
        return lamps.get(selected);
    }

    /** That lamp in place of the selected one. */
    LightChoice withLamp(Lamp other) {
        return withLamp(selected, other);
    }

    LightChoice withLamp(int index, Lamp other) {
        var next = new ArrayList<>(lamps);
        next.set(index, other);
        return with(next, index);
    }

    /** One lamp more, selected, unless there are {@value #MOST_LAMPS}. */
    LightChoice grown() {
        if (lamps.size() == MOST_LAMPS) return this;
        var next = new ArrayList<>(lamps);
        Lamp last = lamp();
        next.add(Lamp.at(-last.x(), -last.y(), last.z()).withStrength(0.5));
        return with(next, next.size() - 1);
    }

    /** Without the selected lamp, unless it is the only one. */
    LightChoice shrunk() {
        if (lamps.size() == 1) return this;
        var next = new ArrayList<>(lamps);
        next.remove(selected);
        return with(next, Math.min(selected, next.size() - 1));
    }

    /** What all lamps that shine make of the scene. */
    LightModel model() {
        double[] everywhere = {ambient, ambient, ambient};
        return new LightModel(
                everywhere,
                localViewer,
                twoSided,
                reflection,
                lamps.stream().filter(Lamp::on).map(Lamp::light).toList());
    }
}
