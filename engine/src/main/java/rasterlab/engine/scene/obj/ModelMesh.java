package rasterlab.engine.scene.obj;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.scene.Mesh;

/**
 * Makes a model one mesh with a number of a finish for each face: the model's faces, fitted, then
 * thin bodies for its lines and points.
 *
 * <p>The finish of a face has the number of its material, that of a line or point comes {@code
 * materials} behind it.
 */
final class ModelMesh {
    private final ObjModel model;
    private final UpAxis up;
    private final Notes notes;
    private final double[] modelNormals;
    private final double[] modelPlaces;
    private final double[] modelColors;
    private final Doubles positions = new Doubles();
    private final Doubles normals = new Doubles();
    private final Doubles places = new Doubles();
    private final Doubles colors = new Doubles();
    private final List<int[]> faces = new ArrayList<>();
    private final Ints finishOf = new Ints();
    private boolean textured;

    private ModelMesh(ObjModel model, UpAxis up, Notes notes) {
        this.model = model;
        this.up = up;
        this.notes = notes;
        modelNormals = up.toScene(model.normals());
        modelPlaces = model.texturePlaces();
        modelColors = model.colors();
    }

    /**
     * @param finishOf the number of each face's finish
     */
    record Made(Mesh mesh, int[] finishOf) {}

    /**
     * @param name of the file, for notes
     * @throws IllegalArgumentException if the model cannot be fitted
     */
    static Made of(String name, ObjModel model, UpAxis up, Notes notes) {
        var made = new ModelMesh(model, up, notes);
        int[] used = made.used();
        double[] fitted = up.toScene(new Fit(model.positions(), used).fitted(used));
        try {
            return made.all(fitted);
        } catch (IllegalArgumentException refused) {
            return made.whatFits(name, fitted);
        }
    }

    /** The numbers of the vertices that something is drawn at, each once. */
    private int[] used() {
        var used = new BitSet();
        for (int f = 0; f < model.faceCount(); f++)
            for (int k = 0; k < model.cornerCount(f); k++) used.set(model.position(f, k));
        for (int s = 0; s < model.strokeCount(); s++) {
            used.set(model.strokeFrom(s));
            used.set(model.strokeTo(s));
        }
        return used.stream().toArray();
    }

    private Made all(double[] fitted) {
        start(fitted);
        for (int f = 0; f < model.faceCount(); f++) addFace(f, corners(f));
        addStrokes(fitted);
        return made();
    }

    /** A face that is tiny beside its model may lose its flatness where it is moved and scaled. */
    private Made whatFits(String name, double[] fitted) {
        start(fitted);
        for (int f = 0; f < model.faceCount(); f++) addWhatFits(name, f, fitted);
        addStrokes(fitted);
        return made();
    }

    private void start(double[] fitted) {
        positions.clear();
        for (double coordinate : fitted) positions.add(coordinate);
        normals.clear();
        places.clear();
        colors.clear();
        faces.clear();
        finishOf.clear();
    }

    private int[] corners(int face) {
        int[] all = new int[model.cornerCount(face)];
        for (int k = 0; k < all.length; k++) all[k] = k;
        return all;
    }

    private void addWhatFits(String name, int face, double[] fitted) {
        int[] all = corners(face);
        if (fits(face, all, fitted)) {
            addFace(face, all);
            return;
        }
        notes.countIn(name, "a face too small beside its model was cut or left out");
        for (int k = 1; k + 1 < all.length; k++) {
            int[] triangle = {0, k, k + 1};
            if (fits(face, triangle, fitted)) addFace(face, triangle);
        }
    }

    private boolean fits(int face, int[] corners, double[] fitted) {
        double[] xyz = new double[3 * corners.length];
        int[] numbers = new int[corners.length];
        for (int k = 0; k < corners.length; k++) {
            System.arraycopy(fitted, 3 * model.position(face, corners[k]), xyz, 3 * k, 3);
            numbers[k] = k;
        }
        try {
            return new Mesh(xyz, new int[][] {numbers}).faceCount() == 1;
        } catch (IllegalArgumentException refused) {
            return false;
        }
    }

    private void addFace(int face, int[] corners) {
        int[] numbers = new int[corners.length];
        Optional<ObjMaterial.Map> map = model.materials().get(model.material(face)).diffuseMap();
        for (int k = 0; k < corners.length; k++) {
            numbers[k] = model.position(face, corners[k]);
            int normal = model.normal(face, corners[k]);
            for (int axis = 0; axis < 3; axis++) normals.add(modelNormals[3 * normal + axis]);
            addPlace(model.texturePlace(face, corners[k]), map);
            addColor(numbers[k], numbers[k], 0);
        }
        faces.add(numbers);
        finishOf.add(model.material(face));
    }

    /** Adds the place that the texture's options make of a corner's; 0, 0 where it has none. */
    private void addPlace(int place, Optional<ObjMaterial.Map> map) {
        textured |= place != Faces.NONE;
        for (int axis = 0; axis < 2; axis++) {
            double at = place == Faces.NONE ? 0 : modelPlaces[2 * place + axis];
            places.add(
                    map.isEmpty() || place == Faces.NONE
                            ? at
                            : map.get().scale().get(axis) * at + map.get().offset().get(axis));
        }
    }

    /**
     * Adds a colour between those of two vertices, where the model has any.
     *
     * @param share of the other's
     */
    private void addColor(int one, int other, double share) {
        for (int c = 0; c < 3 && modelColors.length > 0; c++)
            colors.add((1 - share) * modelColors[3 * one + c] + share * modelColors[3 * other + c]);
    }

    private void addStrokes(double[] fitted) {
        for (int s = 0; s < model.strokeCount(); s++) {
            var body =
                    StrokeFaces.between(
                            at(fitted, model.strokeFrom(s)), at(fitted, model.strokeTo(s)));
            int first = positions.size() / 3;
            for (double coordinate : body.xyz()) positions.add(coordinate);
            for (int[] face : body.faces()) {
                int[] numbers = new int[face.length];
                double[] normal = StrokeFaces.normal(body.xyz(), face);
                for (int k = 0; k < face.length; k++) {
                    numbers[k] = first + face[k];
                    for (double coordinate : normal) normals.add(coordinate);
                    places.add(0);
                    places.add(0);
                    addColor(model.strokeFrom(s), model.strokeTo(s), body.share(face[k]));
                }
                faces.add(numbers);
                finishOf.add(model.materials().size() + model.strokeMaterial(s));
            }
        }
    }

    private static double[] at(double[] xyz, int vertex) {
        return new double[] {xyz[3 * vertex], xyz[3 * vertex + 1], xyz[3 * vertex + 2]};
    }

    private Made made() {
        Mesh mesh =
                new Mesh(positions.all(), faces.toArray(int[][]::new)).withNormals(normals.all());
        if (modelColors.length > 0) mesh = mesh.withColors(colors.all());
        return new Made(textured ? mesh.withTexture(places.all()) : mesh, finishOf.all());
    }
}
