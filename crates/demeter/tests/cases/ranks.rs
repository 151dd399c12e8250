//! Ranks that are threads of one process: what processes would tell each other goes through channels.

use demeter::comm::{Message, Ranks, Traffic};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex};

/// One of several ranks.
#[derive(Debug)]
pub struct ThreadRank {
    rank: usize,
    tell: Vec<Mutex<Sender<Vec<u8>>>>,
    hear: Vec<Mutex<Receiver<Vec<u8>>>>,
    traffic: Arc<Mutex<Traffic>>,
}

impl ThreadRank {
    fn all(count: usize) -> Vec<Self> {
        let mut ranks: Vec<Self> = (0..count)
            .map(|rank| Self {
                rank,
                tell: Vec::new(),
                hear: Vec::new(),
                traffic: Arc::default(),
            })
            .collect();
        for from in 0..count {
            for to in 0..count {
                let (tell, hear) = channel();
                ranks[from].tell.push(Mutex::new(tell));
                ranks[to].hear.push(Mutex::new(hear));
            }
        }
        ranks
    }

    fn send(&self, to: usize, bytes: &[u8]) {
        self.tell[to].lock().unwrap().send(bytes.to_vec()).unwrap();
    }

    fn receive(&self, from: usize) -> Vec<u8> {
        self.hear[from].lock().unwrap().recv().unwrap()
    }
}

impl Ranks for ThreadRank {
    fn rank(&self) -> usize {
        self.rank
    }

    fn count(&self) -> usize {
        self.tell.len()
    }

    fn gather(&self, mine: &[u8]) -> Vec<Vec<u8>> {
        {
            let mut traffic = self.traffic.lock().unwrap();
            traffic.rounds += 1;
            traffic.round_bytes += mine.len() as u64;
        }
        (0..self.count()).for_each(|to| self.send(to, mine));
        (0..self.count()).map(|from| self.receive(from)).collect()
    }

    fn tell(&self, rank: usize, mine: &[u8]) {
        self.traffic.lock().unwrap().gathered_bytes += mine.len() as u64;
        self.send(rank, mine);
    }

    fn hear(&self, rank: usize) -> Vec<u8> {
        self.receive(rank)
    }

    fn swap(&self, rank: usize, mine: &[u8]) -> Vec<u8> {
        self.traffic.lock().unwrap().joined_bytes += mine.len() as u64;
        self.send(rank, mine);
        self.receive(rank)
    }

    fn begin_round(&self) {
        self.traffic.lock().unwrap().rounds += 1;
    }

    fn exchange(&self, messages: &mut [Message], meanwhile: &mut dyn FnMut()) {
        for message in &*messages {
            let mut traffic = self.traffic.lock().unwrap();
            traffic.messages += 1;
            traffic.bytes += 8 * message.tell.len() as u64;
            drop(traffic);
            self.send(message.rank, bytemuck_bytes(&message.tell).as_slice());
        }
        meanwhile();
        for message in messages {
            let heard = self.receive(message.rank);
            assert_eq!(heard.len(), 8 * message.hear.len());
            for (number, bytes) in message.hear.iter_mut().zip(heard.chunks_exact(8)) {
                *number = f64::from_ne_bytes(bytes.try_into().unwrap());
            }
        }
    }

    fn traffic(&self) -> Traffic {
        *self.traffic.lock().unwrap()
    }

    fn give_up(&self, reason: &str) -> ! {
        panic!("rank {}: {reason}", self.rank)
    }
}

fn bytemuck_bytes(numbers: &[f64]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_ne_bytes()).collect()
}

/// What every rank of so many makes of its work, each on a thread.
pub fn on_ranks<T: Send>(count: usize, work: impl Fn(Box<dyn Ranks>) -> T + Sync) -> Vec<T> {
    let all = on_ranks_counting(count, work);
    all.into_iter().map(|(made, _)| made).collect()
}

/// The same with what every rank told others.
pub fn on_ranks_counting<T: Send>(count: usize, work: impl Fn(Box<dyn Ranks>) -> T + Sync) -> Vec<(T, Traffic)> {
    std::thread::scope(|scope| {
        let work = &work;
        let running: Vec<_> = (ThreadRank::all(count).into_iter())
            .map(|rank| {
                let traffic = Arc::clone(&rank.traffic);
                (scope.spawn(move || work(Box::new(rank))), traffic)
            })
            .collect();
        let ended = |(rank, traffic): (std::thread::ScopedJoinHandle<'_, T>, Arc<Mutex<Traffic>>)| {
            let made = rank.join().unwrap();
            let told = *traffic.lock().unwrap();
            (made, told)
        };
        running.into_iter().map(ended).collect()
    })
}
