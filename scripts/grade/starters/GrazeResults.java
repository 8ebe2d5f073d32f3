import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads cases of Graze as CSV, lets your intersect answer them, and writes a file of results.
 *
 * <p>java GrazeResults.java cases.csv results.csv
 *
 * <p>`npm run grade -- --cases cases.csv` writes the cases, as does the page Check. Fill in
 * intersect.
 */
public class GrazeResults {
    /**
     * All t at which the line E + t d meets the shape: ascending, a tangent once. Throw for what is
     * no shape or no ray. The numbers have the symbols as keys: of a sphere Cx, Cy, Cz and r; an
     * axis is in words.
     */
    static double[] intersect(
            String kind,
            Map<String, Double> numbers,
            Map<String, String> words,
            double[] E,
            double[] d) {
        return new double[] {};
    }

    public static void main(String[] args) throws IOException {
        List<String> lines = Files.readAllLines(Path.of(args[0]));
        String[] head = lines.get(0).split(",", -1);
        List<String> out = new ArrayList<>();
        out.add("id,t1,t2");
        for (String line : lines.subList(1, lines.size())) {
            out.add(answer(head, line.split(",", -1)));
        }
        Files.write(Path.of(args[1]), out);
    }

    static String answer(String[] head, String[] row) {
        Map<String, Double> numbers = new HashMap<>();
        Map<String, String> words = new HashMap<>();
        for (int i = 2; i < row.length; i++) {
            if (row[i].isEmpty()) continue;
            try {
                numbers.put(head[i], Double.valueOf(row[i]));
            } catch (NumberFormatException error) {
                words.put(head[i], row[i]);
            }
        }
        StringBuilder text = new StringBuilder(row[0]);
        try {
            double[] E = {numbers.get("Ex"), numbers.get("Ey"), numbers.get("Ez")};
            double[] d = {numbers.get("dx"), numbers.get("dy"), numbers.get("dz")};
            for (double t : intersect(row[1], numbers, words, E, d)) text.append(",").append(t);
        } catch (RuntimeException error) {
            text.append(",error,").append(String.valueOf(error.getMessage()).replace(",", " "));
        }
        return text.toString();
    }
}
