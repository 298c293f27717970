package rasterlab.engine.light;

import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.Reflection;
import rasterlab.engine.transform.Angle;

/** A light with all that does not depend on the point worked out. */
final class PlacedLight {
    /** The strength of a light in the point itself, where the formula has no number. */
    private static final double MOST = 1e100;

    private final LightSource source;
    private final Attenuation attenuation;
    private final double x;
    private final double y;
    private final double z;
    private final boolean directional;
    private final boolean coned;
    private final double coneX;
    private final double coneY;
    private final double coneZ;
    private final double rim;
    private final double exponent;

    PlacedLight(Light light) {
        source = light.source();
        attenuation = source.attenuation();
        directional = light.directional();
        double[] place = {light.x(), light.y(), light.z()};
        if (directional) UnitVector.normalize(place);
        x = place[0];
        y = place[1];
        z = place[2];
        coned = !source.cone().shinesAllAround();
        double[] axis = source.cone().direction().clone();
        UnitVector.normalize(axis);
        coneX = axis[0];
        coneY = axis[1];
        coneZ = axis[2];
        rim = Angle.ofDegrees(source.cone().cutoff()).cos();
        exponent = source.cone().exponent();
    }

    /**
     * Adds what falls on a point: ambient, diffuse and specular light, three shares each.
     *
     * @param px x of the point
     * @param nx x of the normal, of length 1; or all three 0 where there is none
     * @param vx x of the direction to the eye, of length 1
     */
    void fallOn(
            double px,
            double py,
            double pz,
            double nx,
            double ny,
            double nz,
            double vx,
            double vy,
            double vz,
            Reflection reflection,
            double shininess,
            double[] fallen) {
        double lx = x;
        double ly = y;
        double lz = z;
        double strength = 1;
        if (!directional) {
            lx -= px;
            ly -= py;
            lz -= pz;
            double distance = Math.sqrt(lx * lx + ly * ly + lz * lz);
            double scale = distance > 0 ? 1 / distance : 0;
            lx *= scale;
            ly *= scale;
            lz *= scale;
            strength = Math.min(attenuation.factor(distance), MOST);
            if (coned) strength *= cone(-(lx * coneX + ly * coneY + lz * coneZ));
        }
        add(source.ambient(), strength, fallen, 0);
        double cosine = nx * lx + ny * ly + nz * lz;
        if (cosine <= 0) return;
        add(source.diffuse(), strength * cosine, fallen, 3);
        if (reflection == Reflection.LAMBERT) return;
        double mirrored = SpecularCosine.cosine(reflection, nx, ny, nz, lx, ly, lz, vx, vy, vz);
        add(source.specular(), strength * Powers.of(mirrored, shininess), fallen, 6);
    }

    /**
     * Finds what falls on each of many points, the same numbers: the factors of the source's
     * ambient, diffuse and specular shares.
     */
    void fallOn(IncidentLight points, Reflection reflection, double shininess) {
        for (int i = 0; i < points.count; i++)
            if (directional) shine(points, i, x, y, z, 1, reflection);
            else fallFromNear(points, i, reflection);
        if (reflection != Reflection.LAMBERT) points.raise(shininess);
    }

    private void fallFromNear(IncidentLight points, int i, Reflection reflection) {
        double lx = x - points.x[i];
        double ly = y - points.y[i];
        double lz = z - points.z[i];
        double distance = Math.sqrt(lx * lx + ly * ly + lz * lz);
        double scale = distance > 0 ? 1 / distance : 0;
        lx *= scale;
        ly *= scale;
        lz *= scale;
        double strength = Math.min(attenuation.factor(distance), MOST);
        if (coned) strength *= cone(-(lx * coneX + ly * coneY + lz * coneZ));
        shine(points, i, lx, ly, lz, strength, reflection);
    }

    /** The specular factor is still to be multiplied by the power of the cosine. */
    private static void shine(
            IncidentLight points,
            int i,
            double lx,
            double ly,
            double lz,
            double strength,
            Reflection reflection) {
        double nx = points.nx[i];
        double ny = points.ny[i];
        double nz = points.nz[i];
        double cosine = nx * lx + ny * ly + nz * lz;
        boolean away = cosine <= 0;
        points.ambient[i] = strength;
        points.diffuse[i] = away ? 0 : strength * cosine;
        boolean dull = away || reflection == Reflection.LAMBERT;
        points.specular[i] = dull ? 0 : strength;
        points.mirrored[i] =
                dull
                        ? 0
                        : SpecularCosine.cosine(
                                reflection,
                                nx,
                                ny,
                                nz,
                                lx,
                                ly,
                                lz,
                                points.vx[i],
                                points.vy[i],
                                points.vz[i]);
    }

    LightSource source() {
        return source;
    }

    private double cone(double cosine) {
        return cosine >= rim ? Powers.of(cosine, exponent) : 0;
    }

    private static void add(double[] rgb, double factor, double[] fallen, int at) {
        fallen[at] += rgb[0] * factor;
        fallen[at + 1] += rgb[1] * factor;
        fallen[at + 2] += rgb[2] * factor;
    }
}
