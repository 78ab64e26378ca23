import geminga.Identity;
import geminga.Mode;
import geminga.Node;
import geminga.Offer;
import geminga.Options;
import geminga.Publisher;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SocketChannel;
import java.time.Duration;

/** See ../clients. */
public final class Sender {
    /** Sends one message. */
    private interface Way {
        void send(byte[] payload) throws IOException;
    }

    private static Way plain(String protocol, int port) throws IOException {
        InetSocketAddress there = new InetSocketAddress("127.0.0.1", port);
        if (protocol.equals("tcp")) {
            SocketChannel channel = SocketChannel.open(there);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            return payload -> channel.write(ByteBuffer.wrap(payload));
        }
        DatagramChannel channel = DatagramChannel.open();
        return payload -> channel.send(ByteBuffer.wrap(payload), there);
    }

    private static long timed(Way way, int count, byte[] payload) throws IOException {
        long begin = System.nanoTime();
        for (int i = 0; i < count; ++i) way.send(payload);
        return System.nanoTime() - begin;
    }

    public static void main(String[] arguments) throws Exception {
        String protocol = arguments[1];
        Mode mode = arguments[0].equals("oto") ? Mode.ONE_TO_ONE : Mode.STREAM;
        Offer offer = Offer.of(mode, Identity.text(arguments[2]));
        try (Node node = Node.open(Options.named("sender"), Node::newThread);
                Publisher publisher = node.publish(protocol.equals("tcp") ? offer.tcp() : offer)) {
            while (!publisher.awaitConsumer(Duration.ofSeconds(1))) { }
            Way library = publisher::send;
            Way plain = plain(protocol, Integer.parseInt(arguments[3]));
            System.out.println("ready");
            BufferedReader orders = new BufferedReader(new InputStreamReader(System.in));
            for (String line = orders.readLine(); line != null && !line.equals("quit"); line = orders.readLine()) {
                String[] words = line.split(" ");
                Way way = words[0].equals("library") ? library : plain;
                System.out.println(timed(way, Integer.parseInt(words[1]), new byte[Integer.parseInt(words[2])]));
            }
        }
    }
}
