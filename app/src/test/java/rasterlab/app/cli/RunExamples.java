package rasterlab.app.cli;

import java.util.Map;

/** One input that every topic of {@code ./lab run} answers with most of its methods. */
final class RunExamples {
    private static final Map<String, String> INPUTS =
            Map.ofEntries(
                    Map.entry("line", "{\"from\":[0,0],\"to\":[5,2],\"window\":[-1,-1,9,9]}"),
                    Map.entry("circle", "{\"center\":[3,4],\"radius\":5}"),
                    Map.entry("ellipse", "{\"center\":[3,4],\"rx\":5,\"ry\":2}"),
                    Map.entry(
                            "fill",
                            "{\"picture\":[\"...#\",\"..#.\",\"#..#\"],\"seed\":[0,0],"
                                    + "\"with\":\"*\",\"connectivity\":4}"),
                    Map.entry(
                            "polygon-fill",
                            "{\"polygon\":[[0,0],[8,1],[3.5,7]],\"rule\":\"evenodd\","
                                    + "\"size\":[9,8]}"),
                    Map.entry(
                            "line-plane",
                            "{\"line\":[[1,2,0],[2,2,3]],\"plane\":[[0,0,1],[4,0,1],[0,4,2]]}"),
                    Map.entry(
                            "point-in-triangle",
                            "{\"triangle\":[[0,0],[8,0],[0,8]],\"points\":[[1,1],[9,9]]}"),
                    Map.entry(
                            "point-in-polygon",
                            "{\"polygon\":[[0,0],[4,0],[4,4],[0,4]],\"points\":[[4,2],[5,5]]}"),
                    Map.entry("triangulate", "{\"polygon\":[[0,0],[4,0],[5,4],[0,3]]}"),
                    Map.entry(
                            "clip-segment",
                            "{\"window\":[0,0,10,10],\"segments\":[[5,2,15,8],[1,2,3,4]]}"),
                    Map.entry(
                            "clip-polygon",
                            "{\"window\":[0,0,10,10],\"polygon\":[[2,2],[14,2],[14,8],[2,8]]}"),
                    Map.entry("clip-volume", "{\"zmin\":0.25,\"segments\":[[0,0,0.125,0.25,0,1]]}"),
                    Map.entry(
                            "visible-faces",
                            "{\"vertices\":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],\"faces\":"
                                    + "[[0,2,1],[0,1,3],[0,3,2],[1,2,3]],\"eye\":[2,3,4]}"),
                    Map.entry(
                            "depth-order",
                            "{\"polygons\":[[[0,0,5],[1,0,5],[0,1,5]],"
                                    + "[[0,0,9],[2,0,9],[2,2,9],[0,2,9]]],\"eye\":[0,0,0]}"),
                    Map.entry(
                            "depth-buffer",
                            "{\"near\":1,\"far\":1000,\"depths\":[900,2],\"to\":[901,800],"
                                    + "\"pixels\":5}"),
                    Map.entry(
                            "depth-triangle",
                            "{\"triangles\":[[[1,1,0.25],[7,2,0.75],[2,6,0.5]]],\"size\":[9,8]}"),
                    Map.entry(
                            "hidden-surfaces",
                            "{\"vertices\":[[0,0,0],[8,0,0],[0,8,0],[0,0,8]],\"faces\":"
                                    + "[[0,2,1],[0,1,3],[0,3,2],[1,2,3]],\"theta\":40,"
                                    + "\"phi\":60,\"rho\":50,\"size\":[24,18]}"),
                    Map.entry(
                            "matrix",
                            "{\"name\":\"ROTAXIS\",\"through\":[1,2,3],\"direction\":[1,2,2],"
                                    + "\"angle\":37}"),
                    Map.entry(
                            "transform",
                            "{\"matrices\":[{\"name\":\"ROT3DX\",\"angle\":9},"
                                    + "[[1,0,0,0],[0,1,0,0],[0,0,1,0.5],[0,0,0,1]]],"
                                    + "\"points\":[[1,2,3],[4,5,6]]}"),
                    Map.entry("view", "{\"points\":[[1,2,3]],\"theta\":10,\"phi\":20,\"rho\":30}"),
                    Map.entry("rotate", "{\"points\":[[1,2],[3,4]],\"degrees\":33.5,\"times\":12}"),
                    Map.entry(
                            "rotate-axis",
                            "{\"points\":[[1,2,3]],\"through\":[1,1,1],\"direction\":[0,1,0],"
                                    + "\"degrees\":45}"),
                    Map.entry(
                            "spline-function",
                            "{\"x\":[0,1,2],\"y\":[0,1,0],\"ends\":{\"kind\":\"slopes\","
                                    + "\"left\":1,\"right\":-1},\"at\":[0.5,1,3]}"),
                    Map.entry(
                            "curve",
                            "{\"kind\":\"bezier\",\"points\":[[0,0],[0,8],[8,8],[8,0]],"
                                    + "\"flatness\":0.25}"),
                    Map.entry(
                            "shade",
                            "{\"normal\":[0,0,2],\"to-light\":[3,0,4],\"to-eye\":[0,1,1],"
                                    + "\"material\":{\"ambient\":0.2,\"diffuse\":[0.5,0.4,0.3],"
                                    + "\"specular\":0.3,\"emission\":0.1,\"shininess\":9},"
                                    + "\"light\":{\"ambient\":0.1,\"attenuation\":[1,0,1],"
                                    + "\"spot\":{\"direction\":[0,0,-1],\"cutoff\":60,"
                                    + "\"exponent\":2}},\"distance\":2,\"global-ambient\":0.2}"),
                    Map.entry(
                            "vertex-normals",
                            "{\"vertices\":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"
                                    + "\"triangles\":[[0,1,2],[0,3,1]]}"),
                    Map.entry(
                            "shade-face",
                            "{\"corners\":[[0,0,0],[1,0,0],[0,1,0]],"
                                    + "\"normals\":[[0,0,1],[1,0,2],[0,1,2]],\"lamp\":[2,2,4],"
                                    + "\"eye\":[0,0,5],\"material\":{\"diffuse\":0.5},"
                                    + "\"light\":{\"diffuse\":1},\"global-ambient\":0.2,"
                                    + "\"points\":[[1,0,0],[0.5,0.25,0.25]]}"),
                    Map.entry("color", "{\"rgb\":[1,0.5,0.25]}"),
                    Map.entry("texture-mapping", "{\"from\":[0,0,1],\"to\":[1,2,3],\"pixels\":5}"),
                    Map.entry(
                            "texture-filter",
                            "{\"picture\":[[0,255],[128,64]],"
                                    + "\"pixels\":[[0.3,0.6,0.5,0,0,0.25]]}"));

    private RunExamples() {}

    /** The input of that topic. */
    static String of(String topic) {
        String input = INPUTS.get(topic);
        if (input == null) throw new AssertionError("topic " + topic + " has no example here");
        return input;
    }
}
