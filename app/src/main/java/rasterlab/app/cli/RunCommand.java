package rasterlab.app.cli;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.cli.run.Runs;
import rasterlab.app.cli.run.TopicRun;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;

/** Runs one method on JSON input. */
@Command(
        name = "run",
        mixinStandardHelpOptions = true,
        description = {
            "Runs one method on JSON from standard input and prints JSON.",
            "line: {\"from\":[x,y], \"to\":[x,y], \"window\":[xmin,ymin,xmax,ymax]}, the window",
            "  being optional; answers {\"pixels\":[[x,y],...]} in drawing order, and for wu",
            "  {\"coverage\":[1..255,...]} beside it.",
            "circle: {\"center\":[x,y], \"radius\":r}; ellipse: {\"center\":[x,y], \"rx\":a,",
            "  \"ry\":b}; answers {\"pixels\":[[x,y],...]}.",
            "fill: {\"picture\":[\"....\",...], \"seed\":[x,y], \"with\":\"*\", \"connectivity\":4 or 8},",
            "  a picture being rows of characters; answers {\"picture\":[...]}.",
            "polygon-fill: {\"polygon\":[[x,y],...], \"rule\":\"evenodd\" or \"nonzero\",",
            "  \"size\":[w,h]}; answers {\"pixels\":[[x,y],...]} row by row.",
            "spline-function: {\"x\":[...], \"y\":[...], \"ends\":{\"kind\":KIND}, \"at\":[...]},",
            "  KIND being natural, not-a-knot, periodic, or slopes with \"left\" and \"right\"; answers",
            "  {\"y\":[...], \"coefficients\":[[a,b,c,d],...]}, a + b*s + c*s^2 + d*s^3 for each piece.",
            "curve: {\"kind\":KIND, \"points\":[[x,y],...]} with \"at\":[t,...] from 0 to 1 or",
            "  \"flatness\" in pixels, KIND being bezier, hermite (start, end, derivatives at both),",
            "  catmull-rom or b-spline; answers {\"points\":[[x,y],...], \"segments\":n}.",
            "point-in-triangle: {\"triangle\":[[x,y],[x,y],[x,y]], \"points\":[[x,y],...]};",
            "  answers {\"inside\":[true,...]}.",
            "point-in-polygon: {\"polygon\":[[x,y],...], \"points\":[[x,y],...]}; the same.",
            "triangulate: {\"polygon\":[[x,y],...]}; answers {\"triangles\":[[i,j,k],...]},",
            "  corner numbers from 0, counter-clockwise with y up.",
            "clip-segment: {\"window\":[xmin,ymin,xmax,ymax], \"segments\":[[x0,y0,x1,y1],...]};",
            "  answers {\"segments\":[...]} in their order, null where nothing is left.",
            "clip-polygon: {\"window\":..., \"polygon\":[[x,y],...]}, the window as above or the",
            "  corners of a convex polygon; answers {\"polygons\":[[[x,y],...],...]}, counter-clockwise.",
            "clip-volume: {\"zmin\":z, \"segments\":[[x0,y0,z0,x1,y1,z1],...]}, 0 < z < 1;",
            "  answers {\"segments\":[...]} as clip-segment does.",
            "matrix: {\"name\":\"ROT3DX\", \"angle\":30}, see `./lab methods matrix`;",
            "  answers {\"matrix\":[[...],...]} row by row, for points as rows.",
            "transform: {\"matrices\":[...], \"points\":[[x,y,z],...]}, each matrix by name as",
            "  above or by its rows; answers {\"points\":[...], \"h\":[...]}, null where h is 0.",
            "view: {\"points\":[[x,y,z],...], \"theta\":a, \"phi\":b, \"rho\":r}; answers",
            "  {\"points\":[[x,y,z],...]} in the left-handed space of the eye.",
            "rotate: {\"points\":[[x,y],...], \"degrees\":a, \"times\":n}, times being optional;",
            "  answers {\"points\":[[x,y],...]}.",
            "rotate-axis: {\"points\":[[x,y,z],...], \"through\":[x,y,z], \"direction\":[l,m,n],",
            "  \"degrees\":a}; answers {\"points\":[[x,y,z],...]}.",
            "shade: {\"normal\":[x,y,z], \"to-light\":[x,y,z], \"to-eye\":[x,y,z], \"material\":M,",
            "  \"light\":L, \"distance\":d, \"global-ambient\":C}, the last three being optional, M",
            "  {\"ambient\":C, \"diffuse\":C, \"specular\":C, \"emission\":C, \"shininess\":n}, L",
            "  {\"ambient\":C, \"diffuse\":C, \"specular\":C, \"attenuation\":[c,l,q], \"spot\":",
            "  {\"direction\":[x,y,z], \"cutoff\":a, \"exponent\":e}}, C [r,g,b] or one number; of M",
            "  and L each field is optional. L's own ambient light is weakened with its distance,",
            "  1/(c + l*d + q*d^2), global-ambient is not. Answers {\"intensity\":[r,g,b],",
            "  \"terms\":{...}}.",
            "vertex-normals: {\"vertices\":[[x,y,z],...], \"triangles\":[[i,j,k],...]}, numbers from 0,",
            "  counter-clockwise from outside; answers {\"normals\":[[x,y,z],...]}.",
            "shade-face: {\"corners\":[[x,y,z],...], \"normals\":[[x,y,z],...], \"lamp\":[x,y,z],",
            "  \"eye\":[x,y,z], \"material\":M, \"light\":L, \"global-ambient\":C, \"points\":",
            "  [[a,b,c],...]}, a point by its shares of the three corners; answers",
            "  {\"intensity\":[[r,g,b],...]}.",
            "color: {\"rgb\":[r,g,b]}, or \"cmy\", \"cmyk\", \"hsv\":[h,s,v] or \"hvs\":[h,v,s]; shares",
            "  from 0 to 1, h in degrees, null for a grey; answers all five and \"levels\", 0 to 255.",
            "texture-mapping: {\"from\":[s,t,depth], \"to\":[s,t,depth], \"pixels\":n}, the centres of",
            "  a row's first and last pixel; answers {\"coordinates\":[[s,t],...]}.",
            "texture-filter: {\"picture\":[[level,...],...], \"pixels\":[[s,t,dsdx,dtdx,dsdy,dtdy],...]},",
            "  rows of grey levels 0 to 255, the top row first, (s,t) = (0,0) at the bottom left;",
            "  answers {\"levels\":[level,...]}."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:answered; with --lines, all input was read",
            "2:unknown topic or method, or the input is wrong",
            "3:the method refuses this input",
            "4:the method crashed, did not end, or has more pixels than one answer may have"
        },
        footer = {
            "",
            "Example: echo '{\"from\":[0,0],\"to\":[5,2]}' | ./lab run line bresenham --steps"
        })
final class RunCommand implements Callable<Integer> {
    /** The most bytes of one input: 64 MiB. */
    private static final int LONGEST_INPUT = 64 << 20;

    private final Console console;
    private final JsonFactory json = new JsonFactory();

    @Parameters(index = "0", paramLabel = "TOPIC", description = "such as line")
    private String topic;

    @Parameters(index = "1", paramLabel = "METHOD", description = "see `./lab methods TOPIC`")
    private String method;

    @Option(
            names = "--steps",
            description =
                    "adds each step; where a method decides by a value, that value and its formula")
    private boolean steps;

    @Option(
            names = "--lines",
            description = {
                "reads one JSON object per line and answers each with one line, in order;",
                "a refused line is answered with {\"error\":\"...\"}"
            })
    private boolean lines;

    RunCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        TopicRun run = Runs.named(topic);
        Runs.requireMethod(run, method);
        try (var generator = generator()) {
            if (lines) answerLines(run, generator);
            else answerWhole(run, generator);
        }
        return ExitCode.DONE;
    }

    private JsonGenerator generator() throws IOException {
        var generator =
                json.createGenerator(new BufferedOutputStream(console.out(), 1 << 16))
                        .disable(JsonGenerator.Feature.AUTO_CLOSE_TARGET)
                        .disable(JsonGenerator.Feature.AUTO_CLOSE_JSON_CONTENT);
        generator.setRootValueSeparator(null);
        return generator;
    }

    private void answerWhole(TopicRun run, JsonGenerator out) throws IOException {
        byte[] text = console.in().readNBytes(LONGEST_INPUT + 1);
        if (text.length > LONGEST_INPUT) throw tooLong("the input");
        writeLine(out, run.answer(method, text, text.length, steps));
    }

    private void answerLines(TopicRun run, JsonGenerator out) throws IOException {
        var input = new InputLines(console.in(), LONGEST_INPUT);
        while (input.next()) {
            writeLine(out, answered(run, input));
            if (input.drained()) flush(out);
            if (console.out().checkError()) return;
        }
    }

    private TopicRun.Answer answered(TopicRun run, InputLines input) {
        try {
            if (input.tooLong()) throw tooLong("the line");
            if (input.blank())
                throw Complaint.badInput("the line is empty; expected a JSON object");
            return run.answer(method, input.bytes(), input.length(), steps);
        } catch (Complaint complaint) {
            String error = Failures.oneLine(complaint.getMessage());
            return json -> json.writeStringField("error", error);
        }
    }

    private static Complaint tooLong(String what) {
        return Complaint.badInput(what + " is longer than " + LONGEST_INPUT + " bytes");
    }

    private static void writeLine(JsonGenerator out, TopicRun.Answer answer) throws IOException {
        out.writeStartObject();
        answer.write(out);
        out.writeEndObject();
        out.writeRaw('\n');
    }

    private void flush(JsonGenerator out) throws IOException {
        out.flush();
        console.out().flush();
    }
}
